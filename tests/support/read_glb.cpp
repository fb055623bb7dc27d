#include "tests/support/read_glb.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include <Eigen/Geometry>

namespace tests {

namespace {

using sim::Vec3;
using Numbers = std::vector<double>;
using nlohmann::literals::operator""_json_pointer;

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

template <class T>
double numberAt(const std::string& bytes, std::size_t at) {
  T number{};
  std::memcpy(&number, bytes.data() + at, sizeof(number));
  return static_cast<double>(number);
}

std::size_t componentsOf(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
}

/// Metres, y up, to centimetres, z up.
Vec3 ours(const Vec3& v) {
  return {v.x(), -v.z(), v.y()};
}

std::string pointerTo(std::size_t node) {
  return "/nodes/" + std::to_string(node) + "/extensions/KHR_node_visibility/visible";
}

}  // namespace

ReadGlb::ReadGlb(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::size_t length = wordAt(bytes, 12);
  json_ = nlohmann::json::parse(bytes.substr(20, length));
  if (20 + length < bytes.size()) binary_ = bytes.substr(28 + length, wordAt(bytes, 20 + length));
}

Numbers ReadGlb::numbers(std::size_t accessor) const {
  const auto& read = json_.at("accessors").at(accessor);
  const auto& view = json_.at("bufferViews").at(read.at("bufferView").get<std::size_t>());
  const int type = read.at("componentType");
  const std::size_t size = type == 5126 || type == 5125 ? 4 : type == 5123 ? 2 : 1;
  const std::size_t components = componentsOf(read.at("type"));
  const std::size_t stride = view.value("byteStride", size * components);
  const std::size_t start =
      view.value("byteOffset", std::size_t{0}) + read.value("byteOffset", std::size_t{0});
  Numbers result;
  for (std::size_t i = 0; i < read.at("count").get<std::size_t>(); ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      const std::size_t at = start + i * stride + c * size;
      if (at + size > binary_.size()) throw std::out_of_range("an accessor reaches beyond its buffer");
      result.push_back(type == 5126   ? numberAt<float>(binary_, at)
                       : type == 5125 ? numberAt<std::uint32_t>(binary_, at)
                       : type == 5123 ? numberAt<std::uint16_t>(binary_, at)
                                      : numberAt<std::uint8_t>(binary_, at));
    }
  }
  return result;
}

std::size_t ReadGlb::indexOf(const std::string& name) const {
  const auto& nodes = json_.at("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].at("name") == name) return i;
  }
  throw std::out_of_range("there is no node " + name);
}

const nlohmann::json& ReadGlb::node(const std::string& name) const {
  return json_.at("nodes").at(indexOf(name));
}

Numbers ReadGlb::keyTimes() const {
  std::set<double> times;
  for (const auto& animation : json_.value("animations", nlohmann::json::array())) {
    for (const auto& sampler : animation.at("samplers")) {
      for (const double time : numbers(sampler.at("input"))) times.insert(time);
    }
  }
  return {times.begin(), times.end()};
}

Numbers ReadGlb::sampled(const nlohmann::json& sampler, double seconds) const {
  const Numbers times = numbers(sampler.at("input"));
  const Numbers values = numbers(sampler.at("output"));
  const std::size_t size = values.size() / times.size();
  const auto valueOf = [&](std::size_t key) {
    return Numbers(values.begin() + static_cast<std::ptrdiff_t>(key * size),
                   values.begin() + static_cast<std::ptrdiff_t>((key + 1) * size));
  };
  const auto next =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), seconds) - times.begin());
  if (next == 0) return valueOf(0);
  const Numbers before = valueOf(next - 1);
  if (next == times.size() || sampler.value("interpolation", "LINEAR") == "STEP") return before;
  const double share = (seconds - times[next - 1]) / (times[next] - times[next - 1]);
  const Numbers after = valueOf(next);
  if (size == 4) {
    const Eigen::Quaterniond mixed =
        Eigen::Quaterniond(before[3], before[0], before[1], before[2])
            .slerp(share, Eigen::Quaterniond(after[3], after[0], after[1], after[2]));
    return {mixed.x(), mixed.y(), mixed.z(), mixed.w()};
  }
  Numbers mixed;
  for (std::size_t i = 0; i < size; ++i) mixed.push_back((1.0 - share) * before[i] + share * after[i]);
  return mixed;
}

Numbers ReadGlb::valueAt(std::size_t node, const std::string& path, double seconds, Numbers otherwise) const {
  for (const auto& animation : json_.value("animations", nlohmann::json::array())) {
    for (const auto& channel : animation.at("channels")) {
      const auto& target = channel.at("target");
      const bool meant =
          path == "visible"
              ? target.at("path") == "pointer" &&
                    target.at("extensions").at("KHR_animation_pointer").at("pointer") == pointerTo(node)
              : target.at("path") == path && target.at("node") == node;
      if (meant)
        return sampled(animation.at("samplers").at(channel.at("sampler").get<std::size_t>()), seconds);
    }
  }
  return json_.at("nodes").at(node).value(path, otherwise);
}

std::vector<std::size_t> ReadGlb::wayTo(std::size_t node) const {
  const auto& nodes = json_.at("nodes");
  for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
    for (const std::size_t child : nodes[parent].value("children", std::vector<std::size_t>())) {
      if (child != node) continue;
      std::vector<std::size_t> way = wayTo(parent);
      way.push_back(node);
      return way;
    }
  }
  return {node};
}

bool ReadGlb::isVisible(std::size_t node, double seconds) const {
  const auto& stated = json_.at("nodes").at(node);
  bool visible = true;
  if (stated.contains("extensions"))
    visible = stated.at("extensions").value("/KHR_node_visibility/visible"_json_pointer, true);
  return valueAt(node, "visible", seconds, {visible ? 1.0 : 0.0}).front() != 0.0;
}

std::vector<std::string> ReadGlb::shownAt(double seconds, bool extension) const {
  std::vector<std::string> shown;
  for (std::size_t node = 0; node < json_.at("nodes").size(); ++node) {
    if (!json_.at("nodes")[node].contains("mesh")) continue;
    const auto way = wayTo(node);
    const bool there = std::all_of(way.begin(), way.end(), [&](std::size_t at) {
      return extension ? isVisible(at, seconds)
                       : valueAt(at, "scale", seconds, {1.0, 1.0, 1.0}) != Numbers{0.0, 0.0, 0.0};
    });
    if (there) shown.push_back(json_.at("nodes")[node].at("name"));
  }
  return shown;
}

std::vector<ReadGlb::Triangle> ReadGlb::triangles(const std::string& name, double seconds) const {
  const std::size_t index = indexOf(name);
  Eigen::Affine3d world = Eigen::Affine3d::Identity();
  for (const std::size_t at : wayTo(index)) {
    const Numbers t = valueAt(at, "translation", seconds, {0.0, 0.0, 0.0});
    const Numbers r = valueAt(at, "rotation", seconds, {0.0, 0.0, 0.0, 1.0});
    world = world * Eigen::Translation3d(t[0], t[1], t[2]) * Eigen::Quaterniond(r[3], r[0], r[1], r[2]);
  }
  std::vector<Triangle> result;
  const auto& mesh = json_.at("meshes").at(json_.at("nodes")[index].at("mesh").get<std::size_t>());
  for (const auto& primitive : mesh.at("primitives")) {
    const auto& attributes = primitive.at("attributes");
    const Numbers positions = numbers(attributes.at("POSITION"));
    const Numbers normals = numbers(attributes.at("NORMAL"));
    const Numbers damage = numbers(attributes.at("_DAMAGE"));
    const Numbers indices = numbers(primitive.at("indices"));
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (i % 3 == 0) result.emplace_back();
      const auto at = static_cast<std::size_t>(indices[i]);
      const auto vectorOf = [at](const Numbers& of) {
        return Vec3(of[3 * at], of[3 * at + 1], of[3 * at + 2]);
      };
      result.back()[i % 3] = {100.0 * ours(world * vectorOf(positions)),
                              ours(world.linear() * vectorOf(normals)), damage[at]};
    }
  }
  return result;
}

double volumeOf(const std::vector<ReadGlb::Triangle>& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) sum += a.position.dot(b.position.cross(c.position)) / 6.0;
  return sum;
}

bool isClosed(const std::vector<ReadGlb::Triangle>& triangles) {
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto placeOf = [](const Vec3& at) { return Place{at.x(), at.y(), at.z()}; };
  for (const auto& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Place from = placeOf(triangle[c].position);
      const Place to = placeOf(triangle[(c + 1) % 3].position);
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  return !triangles.empty() &&
         std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace tests
