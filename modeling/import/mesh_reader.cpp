#include "modeling/import/mesh_reader.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "modeling/import/mesh_file.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

using sim::Problem;

const char* const kAnew = "export it anew, as OBJ, PLY, STL or glTF";

void addMesh(const aiMesh& mesh, const aiMatrix4x4& worldFromMesh, RawMesh& raw) {
  const auto first = static_cast<std::uint32_t>(raw.points.size());
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D at = worldFromMesh * mesh.mVertices[v];
    raw.points.emplace_back(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z));
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    const auto at = [&](unsigned c) { return first + face.mIndices[c]; };
    if (std::max({face.mIndices[0], face.mIndices[1], face.mIndices[2]}) < mesh.mNumVertices)
      raw.triangles.push_back({at(0), at(1), at(2)});
  }
}

/// Node by node without recursion: a hostile file may nest them as deep as it is long. False: too many
/// triangles.
bool addNodes(const aiScene& scene, RawMesh& raw) {
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting{
      {scene.mRootNode, scene.mRootNode->mTransformation}};
  while (!waiting.empty()) {
    const auto [node, worldFromNode] = waiting.back();
    waiting.pop_back();
    for (unsigned m = 0; m < node->mNumMeshes; ++m)
      addMesh(*scene.mMeshes[node->mMeshes[m]], worldFromNode, raw);
    if (raw.triangles.size() > kMostTriangles || raw.points.size() > 3 * kMostTriangles) return false;
    for (unsigned c = 0; c < node->mNumChildren; ++c)
      waiting.emplace_back(node->mChildren[c], worldFromNode * node->mChildren[c]->mTransformation);
  }
  return true;
}

/// What FBX states of itself; other formats fix it.
void addUnits(const aiScene& scene, RawMesh& raw) {
  if (scene.mMetaData == nullptr) return;
  double unit = 0.0;
  float single = 0.0F;
  int up = 0;
  if (scene.mMetaData->Get("UnitScaleFactor", unit)) raw.unit = unit;
  if (raw.unit == 0.0 && scene.mMetaData->Get("UnitScaleFactor", single))
    raw.unit = static_cast<double>(single);
  if (scene.mMetaData->Get("UpAxis", up) && (up == 1 || up == 2)) raw.up = static_cast<std::uint32_t>(up);
}

/// The answer of the reading process: an empty text and the mesh, or why there is none.
sim::ByteWriter read(const std::filesystem::path& file) {
  sim::ByteWriter answer;
  RawMesh raw;
  std::string error;
  try {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_SortByPType);
    if (scene == nullptr || scene->mRootNode == nullptr) {
      error = importer.GetErrorString();
      if (error.empty()) error = "it holds nothing";
    } else if (!addNodes(*scene, raw)) {
      error = "it has more than " + std::to_string(kMostTriangles) + " triangles";
    } else {
      addUnits(*scene, raw);
    }
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  answer.putString(error);
  if (!error.empty()) return answer;
  answer.put(raw.unit);
  answer.put(raw.up);
  answer.putVector(raw.points);
  answer.putVector(raw.triangles);
  return answer;
}

/// What the reading process may take beyond what it has of us.
void limitMyself() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  if (sizes >> pages) {
    const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + kMeshReadingMemory;
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
  }
#endif
  const rlimit seconds{kLongestMeshReading, kLongestMeshReading};
  ::setrlimit(RLIMIT_CPU, &seconds);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  ::alarm(2 * kLongestMeshReading);
}

[[noreturn]] void answerAndEnd(int pipe, const std::filesystem::path& file) {
  limitMyself();
  // Whoever is told of our crashes has nothing to do with a crash in here.
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGXCPU})
    std::signal(signal, SIG_DFL);
  // What assimp says to the terminal is not for the person.
  if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(1);
  bool sent = false;
  try {
    const sim::ByteWriter answer = read(file);
    std::span<const std::byte> rest = answer.bytes();
    while (!rest.empty()) {
      const ssize_t written = ::write(pipe, rest.data(), rest.size());
      if (written <= 0) break;
      rest = rest.subspan(static_cast<std::size_t>(written));
    }
    sent = rest.empty();
  } catch (...) {
    sent = false;
  }
  ::_exit(sent ? 0 : 1);
}

std::vector<std::byte> everythingFrom(int pipe) {
  // No answer is longer than its largest mesh.
  static constexpr std::size_t kMost = kMostTriangles * (3 * sizeof(sim::Vec3) + 12) + 65536;
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> piece;
  while (bytes.size() < kMost) {
    const ssize_t count = ::read(pipe, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
  }
  return bytes;
}

std::string oneShortLine(std::string text) {
  for (char& letter : text)
    if (letter >= 0 && letter < ' ') letter = ' ';
  static constexpr std::size_t kMost = 160;
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  return text;
}

}  // namespace

sim::Result<RawMesh> readMeshApart(const std::filesystem::path& file) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return Problem{file.string(), "this file cannot be read now", "try again"};
  // A program that is started meanwhile must not keep the pipe open.
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  std::fflush(nullptr);
  const pid_t reader = ::fork();
  if (reader == 0) {
    ::close(ends[0]);
    answerAndEnd(ends[1], file);
  }
  ::close(ends[1]);
  const std::vector<std::byte> bytes = reader > 0 ? everythingFrom(ends[0]) : std::vector<std::byte>();
  ::close(ends[0]);
  int status = 0;
  while (reader > 0 && ::waitpid(reader, &status, 0) < 0 && errno == EINTR) {
  }
  sim::ByteReader answer(bytes);
  std::string error;
  if (reader < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0 || !answer.readString(error)) {
    return Problem{file.string(),
                   "no sense can be made of this file, or it is too much for " +
                       std::to_string(kLongestMeshReading) + " seconds and 2 GB",
                   kAnew};
  }
  if (!error.empty())
    return Problem{file.string(), "this mesh cannot be read: " + oneShortLine(error), kAnew};
  RawMesh raw;
  answer.read(raw.unit);
  answer.read(raw.up);
  answer.readVector(raw.points);
  answer.readVector(raw.triangles);
  if (!answer.finished()) return Problem{file.string(), "no sense can be made of this file", kAnew};
  return raw;
}

}  // namespace modeling
