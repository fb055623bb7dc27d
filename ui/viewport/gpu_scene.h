#pragma once

#include <QOpenGLShaderProgram>
#include <memory>
#include <optional>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/gl.h"

namespace ui {

/// Draw data on the graphics card, and the calls that draw it with the program that is bound. Made, used and
/// destroyed with the context current.
class GpuScene {
 public:
  GpuScene(Gl& gl, DrawStatistics& statistics);
  ~GpuScene();
  GpuScene(const GpuScene&) = delete;
  GpuScene& operator=(const GpuScene&) = delete;

  /// Uploads the pieces that are not there yet.
  void show(const std::shared_ptr<const DrawData>& data);
  const DrawData& data() const { return *data_; }
  const std::shared_ptr<const DrawData>& dataPointer() const { return data_; }

  void bindNodePositions();
  /// Faces and, where wanted, shards; of one part, or of all.
  void drawSurface(QOpenGLShaderProgram& program, std::optional<sim::PartIndex> part = {});
  void drawFacesOfCells(QOpenGLShaderProgram& program);
  void drawFacesOfCells(QOpenGLShaderProgram& program, const TopologyDraw::Range& faces);
  void drawShards(QOpenGLShaderProgram& program);
  void drawLevel(QOpenGLShaderProgram& program);
  void drawCollider(QOpenGLShaderProgram& program, std::size_t collider);
  void drawBalls();
  void drawBonds();
  void drawScreen();
  void drawSquare();

 private:
  struct Solid {
    GLuint array = 0;
    GlBuffer vertices;
    GlBuffer indices;
  };

  /// Corners of faces: four a face, but for the indices, of which there are six.
  struct Faces {
    GLuint array = 0;
    GlBuffer nodes;
    GlBuffer normals;
    GlBuffer colours;
    GlBuffer indices;
  };
  struct Shards {
    GLuint array = 0;
    GlBuffer corners;
    GlBuffer colours;
  };
  struct Balls {
    GLuint array = 0;
    GlBuffer balls;
  };
  struct Bonds {
    GLuint array = 0;
    GlBuffer bonds;
    GlBuffer flags;
  };

  void uploadPositions(const MotionDraw& motion);
  void uploadTopology(const TopologyDraw& topology);
  void uploadColliders(const std::vector<sim::Collider>& colliders);
  void describeSurface();
  void describeShards();
  void describeBalls();
  void describeBonds();
  void uploadSolid(Solid& solid, const LevelDraw& draw);
  void destroySolid(Solid& solid);
  void drawSolid(Solid& solid);
  void bindVertices(GLuint array);
  void useNodes(QOpenGLShaderProgram& program);
  void drawFaces(std::uint32_t first, std::size_t count);
  void drawShardCorners(std::uint32_t first, std::size_t count);

  Gl& gl_;
  DrawStatistics& statistics_;
  std::shared_ptr<const DrawData> data_;
  GLuint positions_ = 0;  ///< a texture of four floats a node, 2048 nodes a row
  GLsizei positionRows_ = 0;
  GLuint emptyArray_ = 0;
  Faces surface_;
  Shards shards_;
  Balls balls_;
  Bonds bonds_;
  Solid level_;
  std::vector<std::pair<sim::Collider, Solid>> colliders_;
};

}  // namespace ui
