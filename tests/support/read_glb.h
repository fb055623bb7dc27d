#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/types.h"

namespace tests {

/// A glTF file in one binary, read by what the specification says and no more than tests need: nodes with
/// meshes of triangles, moved by translation, rotation and scale, and shown by KHR_node_visibility.
class ReadGlb {
 public:
  struct Corner {
    sim::Vec3 position = sim::Vec3::Zero();  ///< cm, z up
    sim::Vec3 normal = sim::Vec3::Zero();
    double damage = 0.0;
  };
  using Triangle = std::array<Corner, 3>;

  explicit ReadGlb(const std::filesystem::path& path);

  const nlohmann::json& json() const { return json_; }
  std::vector<double> numbers(std::size_t accessor) const;
  const nlohmann::json& node(const std::string& name) const;

  /// All times of keys, ascending.
  std::vector<double> keyTimes() const;
  /// Names of the nodes with meshes that are there at a time: of no scale 0, or, by `extension`, visible.
  std::vector<std::string> shownAt(double seconds, bool extension) const;
  /// What is drawn of a node at a time.
  std::vector<Triangle> triangles(const std::string& name, double seconds) const;

 private:
  /// Numbers of a channel of a node at a time; those of the node where it has none.
  std::vector<double> valueAt(std::size_t node, const std::string& path, double seconds,
                              std::vector<double> otherwise) const;
  std::vector<double> sampled(const nlohmann::json& sampler, double seconds) const;
  std::size_t indexOf(const std::string& name) const;
  std::vector<std::size_t> wayTo(std::size_t node) const;
  bool isVisible(std::size_t node, double seconds) const;

  nlohmann::json json_;
  std::string binary_;
};

/// Of a closed surface, cm^3; of an open one it means nothing.
double volumeOf(const std::vector<ReadGlb::Triangle>& triangles);

/// Whether each edge from one place to another is there as often as the way back.
bool isClosed(const std::vector<ReadGlb::Triangle>& triangles);

}  // namespace tests
