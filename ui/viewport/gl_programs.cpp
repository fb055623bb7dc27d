#include "ui/viewport/gl_programs.h"

#include <QFile>

namespace ui {
namespace {

QByteArray textOf(const char* name) {
  QFile file(QStringLiteral(":/shaders/%1.glsl").arg(QLatin1String(name)));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray sourceOf(const std::initializer_list<const char*>& names) {
  QByteArray source = "#version 330 core\n" + textOf("common");
  for (const char* name : names) source += textOf(name);
  return source;
}

bool link(QOpenGLShaderProgram& program, const std::initializer_list<const char*>& vertex,
          const std::initializer_list<const char*>& fragment, QString& why) {
  const bool good = program.addShaderFromSourceCode(QOpenGLShader::Vertex, sourceOf(vertex)) &&
                    program.addShaderFromSourceCode(QOpenGLShader::Fragment, sourceOf(fragment)) &&
                    program.link();
  if (!good) why = program.log();
  return good;
}

}  // namespace

bool GlPrograms::build(QString& why) {
  return link(background, {"screen.vert"}, {"background.frag"}, why) &&
         link(ground, {"ground.vert"}, {"shading", "ground.frag"}, why) &&
         link(groundPick, {"ground.vert"}, {"ground_pick.frag"}, why) &&
         link(solid, {"solid.vert"}, {"shading", "solid.frag"}, why) &&
         link(solidDepth, {"solid.vert"}, {"depth.frag"}, why) &&
         link(solidMask, {"solid.vert"}, {"mask.frag"}, why) &&
         link(solidPick, {"solid.vert"}, {"solid_pick.frag"}, why) &&
         link(ball, {"ball.vert"}, {"shading", "ball_surface", "ball.frag"}, why) &&
         link(ballPick, {"ball.vert"}, {"ball_surface", "ball_pick.frag"}, why) &&
         link(bond, {"bond.vert"}, {"bond.frag"}, why) &&
         link(bondPick, {"bond.vert"}, {"bond_pick.frag"}, why) &&
         link(occlusion, {"screen.vert"}, {"occlusion.frag"}, why) &&
         link(outline, {"screen.vert"}, {"outline.frag"}, why);
}

}  // namespace ui
