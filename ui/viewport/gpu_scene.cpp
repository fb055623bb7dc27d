#include "ui/viewport/gpu_scene.h"

#include <cstddef>

#include "ui/viewport/collider_shape.h"

namespace ui {
namespace {

constexpr GLsizei kNodesARow = 2048;

const void* offsetOf(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

QMatrix4x4 worldFromCollider(const sim::Collider& collider) {
  Eigen::Affine3d affine = Eigen::Translation3d(collider.position) * collider.rotation;
  const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> matrix = affine.matrix().cast<float>();
  return QMatrix4x4(matrix.data());
}

template <class Part, class Get>
bool differs(const std::shared_ptr<const DrawData>& before, const DrawData& now, Get get) {
  const std::shared_ptr<const Part>& piece = get(now);
  return piece && (!before || get(*before) != piece);
}

}  // namespace

GpuScene::GpuScene(Gl& gl, DrawStatistics& statistics) : gl_(gl), statistics_(statistics) {
  for (GLuint* array : {&surface_.array, &shards_.array, &balls_.array, &bonds_.array, &emptyArray_})
    gl_.glGenVertexArrays(1, array);
  gl_.glGenTextures(1, &positions_);
  gl_.glBindTexture(GL_TEXTURE_2D, positions_);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  data_ = std::make_shared<const DrawData>();
}

GpuScene::~GpuScene() {
  for (GlBuffer* buffer : {&surface_.nodes, &surface_.normals, &surface_.colours, &surface_.indices,
                           &shards_.corners, &shards_.colours, &balls_.balls, &bonds_.bonds, &bonds_.flags})
    buffer->destroy(gl_);
  destroySolid(level_);
  for (auto& [collider, solid] : colliders_) destroySolid(solid);
  for (GLuint* array : {&surface_.array, &shards_.array, &balls_.array, &bonds_.array, &emptyArray_})
    gl_.glDeleteVertexArrays(1, array);
  gl_.glDeleteTextures(1, &positions_);
}

void GpuScene::show(const std::shared_ptr<const DrawData>& data) {
  if (data == data_) return;
  const std::shared_ptr<const DrawData> before = std::exchange(data_, data);
  const auto upload = [this](GlBuffer& buffer, const auto& items) {
    buffer.upload(gl_, statistics_, GL_ARRAY_BUFFER, items);
  };
  if (differs<LatticeDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.lattice; })) {
    upload(bonds_.bonds, data->lattice->bonds);
  }
  if (differs<TopologyDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.topology; }))
    uploadTopology(*data->topology);
  if (differs<ColourDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.colours; })) {
    upload(surface_.colours, data->colours->corners);
    upload(shards_.colours, data->colours->shards);
  }
  if (differs<NodeDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.nodes; }))
    upload(balls_.balls, data->nodes->balls);
  if (differs<MotionDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.motion; })) {
    uploadPositions(*data->motion);
    upload(surface_.normals, data->motion->normals);
  }
  if (differs<LevelDraw>(
          before, *data, [](const DrawData& d) -> auto& { return d.level; }))
    uploadSolid(level_, *data->level);
  uploadColliders(data->colliders);
  describeSurface();
  describeShards();
  describeBalls();
  describeBonds();
  gl_.glBindVertexArray(0);
}

void GpuScene::uploadPositions(const MotionDraw& motion) {
  const auto count = static_cast<GLsizei>(motion.positions.size());
  const GLsizei whole = count / kNodesARow;
  const GLsizei rest = count % kNodesARow;
  const GLsizei rows = whole + (rest > 0 ? 1 : 0);
  gl_.glBindTexture(GL_TEXTURE_2D, positions_);
  if (rows > positionRows_) {
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kNodesARow, rows, 0, GL_RGBA, GL_FLOAT, nullptr);
    positionRows_ = rows;
  }
  const auto* const first = motion.positions.data();
  if (whole > 0) gl_.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kNodesARow, whole, GL_RGBA, GL_FLOAT, first);
  if (rest > 0)
    gl_.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, whole, rest, 1, GL_RGBA, GL_FLOAT, first + whole * kNodesARow);
  statistics_.uploadedBytes += motion.positions.size() * sizeof(motion.positions[0]);
  ++statistics_.uploadsInAll;
}

void GpuScene::uploadTopology(const TopologyDraw& topology) {
  gl_.glBindVertexArray(surface_.array);
  surface_.nodes.upload(gl_, statistics_, GL_ARRAY_BUFFER, topology.cornerNodes);
  surface_.indices.upload(gl_, statistics_, GL_ELEMENT_ARRAY_BUFFER, topology.indices);
  gl_.glBindVertexArray(0);
  shards_.corners.upload(gl_, statistics_, GL_ARRAY_BUFFER, topology.shards);
  bonds_.flags.upload(gl_, statistics_, GL_ARRAY_BUFFER, topology.bondFlags);
}

void GpuScene::uploadColliders(const std::vector<sim::Collider>& colliders) {
  while (colliders_.size() > colliders.size()) {
    destroySolid(colliders_.back().second);
    colliders_.pop_back();
  }
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const bool isNew = i == colliders_.size();
    if (isNew) colliders_.emplace_back();
    auto& [collider, solid] = colliders_[i];
    if (isNew || collider.shape != colliders[i].shape) uploadSolid(solid, colliderMesh(colliders[i]));
    collider = colliders[i];
  }
}

void GpuScene::describeSurface() {
  gl_.glBindVertexArray(surface_.array);
  if (surface_.nodes.name() == 0 || surface_.normals.name() == 0) return;
  gl_.glBindBuffer(GL_ARRAY_BUFFER, surface_.nodes.name());
  gl_.glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, 0, nullptr);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, surface_.normals.name());
  gl_.glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, 0, nullptr);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, surface_.colours.name());
  gl_.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  for (const GLuint attribute : {0U, 1U, 2U}) gl_.glEnableVertexAttribArray(attribute);
}

void GpuScene::describeShards() {
  gl_.glBindVertexArray(shards_.array);
  if (shards_.corners.name() == 0) return;
  constexpr auto kStride = static_cast<GLsizei>(sizeof(ShardCorner));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, shards_.corners.name());
  gl_.glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, kStride, offsetOf(offsetof(ShardCorner, node)));
  gl_.glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, kStride,
                            offsetOf(offsetof(ShardCorner, normal)));
  gl_.glVertexAttribPointer(3, 3, GL_FLOAT, GL_FALSE, kStride, offsetOf(offsetof(ShardCorner, offset)));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, shards_.colours.name());
  gl_.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  for (const GLuint attribute : {0U, 1U, 2U, 3U}) gl_.glEnableVertexAttribArray(attribute);
}

void GpuScene::describeBalls() {
  gl_.glBindVertexArray(balls_.array);
  if (balls_.balls.name() == 0) return;
  using Ball = NodeDraw::Ball;
  constexpr auto kStride = static_cast<GLsizei>(sizeof(Ball));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, balls_.balls.name());
  gl_.glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, kStride, offsetOf(offsetof(Ball, node)));
  gl_.glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, kStride, offsetOf(offsetof(Ball, radius)));
  gl_.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offsetOf(offsetof(Ball, colour)));
  for (const GLuint attribute : {0U, 1U, 2U}) {
    gl_.glEnableVertexAttribArray(attribute);
    gl_.glVertexAttribDivisor(attribute, 1);
  }
}

void GpuScene::describeBonds() {
  gl_.glBindVertexArray(bonds_.array);
  if (bonds_.bonds.name() == 0) return;
  using Bond = LatticeDraw::Bond;
  constexpr auto kStride = static_cast<GLsizei>(sizeof(Bond));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, bonds_.bonds.name());
  gl_.glVertexAttribIPointer(0, 2, GL_UNSIGNED_INT, kStride, nullptr);
  gl_.glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, offsetOf(offsetof(Bond, restLength)));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, bonds_.flags.name());
  gl_.glVertexAttribIPointer(2, 1, GL_UNSIGNED_BYTE, 0, nullptr);
  for (const GLuint attribute : {0U, 1U, 2U}) {
    gl_.glEnableVertexAttribArray(attribute);
    gl_.glVertexAttribDivisor(attribute, 1);
  }
}

void GpuScene::uploadSolid(Solid& solid, const LevelDraw& draw) {
  using Vertex = LevelDraw::Vertex;
  constexpr auto kStride = static_cast<GLsizei>(sizeof(Vertex));
  if (solid.array == 0) gl_.glGenVertexArrays(1, &solid.array);
  gl_.glBindVertexArray(solid.array);
  solid.vertices.upload(gl_, statistics_, GL_ARRAY_BUFFER, draw.vertices);
  solid.indices.upload(gl_, statistics_, GL_ELEMENT_ARRAY_BUFFER, draw.indices);
  gl_.glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, kStride,
                            offsetOf(offsetof(Vertex, normal)));
  gl_.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offsetOf(offsetof(Vertex, colour)));
  gl_.glVertexAttribPointer(3, 3, GL_FLOAT, GL_FALSE, kStride, nullptr);
  for (const GLuint attribute : {1U, 2U, 3U}) gl_.glEnableVertexAttribArray(attribute);
  gl_.glBindVertexArray(0);
}

void GpuScene::destroySolid(Solid& solid) {
  solid.vertices.destroy(gl_);
  solid.indices.destroy(gl_);
  if (solid.array != 0) gl_.glDeleteVertexArrays(1, &solid.array);
  solid.array = 0;
}

void GpuScene::bindNodePositions() {
  gl_.glActiveTexture(GL_TEXTURE0);
  gl_.glBindTexture(GL_TEXTURE_2D, positions_);
}

void GpuScene::bindVertices(GLuint array) {
  gl_.glBindVertexArray(array);
  ++statistics_.drawCalls;
}

void GpuScene::useNodes(QOpenGLShaderProgram& program) {
  program.setUniformValue("atNodes", true);
  program.setUniformValue("worldFromModel", QMatrix4x4());
  // Without an array a corner is at its node.
  program.setAttributeValue(3, 0.0F, 0.0F, 0.0F);
}

void GpuScene::drawFaces(std::uint32_t first, std::size_t count) {
  if (count == 0) return;
  bindVertices(surface_.array);
  gl_.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_INT,
                     offsetOf(6 * sizeof(std::uint32_t) * first));
}

void GpuScene::drawShardCorners(std::uint32_t first, std::size_t count) {
  if (count == 0) return;
  bindVertices(shards_.array);
  gl_.glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(count));
}

void GpuScene::drawFacesOfCells(QOpenGLShaderProgram& program) {
  if (!data_->motion) return;
  useNodes(program);
  drawFaces(0, data_->topology->faces.size());
}

void GpuScene::drawSurface(QOpenGLShaderProgram& program, std::optional<sim::PartIndex> part) {
  if (!data_->motion) return;
  const TopologyDraw& topology = *data_->topology;
  useNodes(program);
  if (!part) {
    drawFaces(0, topology.faces.size());
    drawShardCorners(0, topology.shards.size());
    return;
  }
  for (const TopologyDraw::Range& range : topology.partFaces) {
    if (range.part == *part) drawFaces(range.first, range.count);
  }
  for (const TopologyDraw::Range& range : topology.partShards) {
    if (range.part == *part) drawShardCorners(range.first, range.count);
  }
}

void GpuScene::drawFacesOfCells(QOpenGLShaderProgram& program, const TopologyDraw::Range& faces) {
  if (!data_->motion) return;
  useNodes(program);
  drawFaces(faces.first, faces.count);
}

void GpuScene::drawShards(QOpenGLShaderProgram& program) {
  if (!data_->motion) return;
  useNodes(program);
  drawShardCorners(0, data_->topology->shards.size());
}

void GpuScene::drawSolid(Solid& solid) {
  if (solid.indices.count() == 0) return;
  bindVertices(solid.array);
  gl_.glDrawElements(GL_TRIANGLES, solid.indices.count(), GL_UNSIGNED_INT, nullptr);
}

void GpuScene::drawLevel(QOpenGLShaderProgram& program) {
  if (!data_->level) return;
  program.setUniformValue("atNodes", false);
  program.setUniformValue("worldFromModel", QMatrix4x4());
  drawSolid(level_);
}

void GpuScene::drawCollider(QOpenGLShaderProgram& program, std::size_t collider) {
  program.setUniformValue("atNodes", false);
  program.setUniformValue("worldFromModel", worldFromCollider(data_->colliders[collider]));
  drawSolid(colliders_[collider].second);
}

void GpuScene::drawBalls() {
  if (!data_->motion || balls_.balls.count() == 0) return;
  bindVertices(balls_.array);
  gl_.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, balls_.balls.count());
}

void GpuScene::drawBonds() {
  if (!data_->motion || bonds_.bonds.count() == 0) return;
  bindVertices(bonds_.array);
  gl_.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, bonds_.bonds.count());
}

void GpuScene::drawScreen() {
  bindVertices(emptyArray_);
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GpuScene::drawSquare() {
  bindVertices(emptyArray_);
  gl_.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace ui
