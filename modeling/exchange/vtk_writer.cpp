#include <vector>

#include "modeling/exchange/damage.h"
#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/text/text_output.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

constexpr std::uint8_t kLine = 3;  // VTK_LINE

/// The arrays of a .vtu file: what is said of each in the XML, and all their bytes behind it.
class Appended {
 public:
  template <class T>
  std::string add(const char* name, const char* type, unsigned components, const std::vector<T>& values) {
    const std::string said = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name +
                             "\" NumberOfComponents=\"" + std::to_string(components) +
                             "\" format=\"appended\" offset=\"" + std::to_string(bytes_.size()) + "\"/>\n";
    bytes_.put(static_cast<std::uint64_t>(values.size() * sizeof(T)));
    bytes_.putBytes(std::as_bytes(std::span(values)));
    return said;
  }

  std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes_.bytes().data()), bytes_.size()};
  }

 private:
  sim::ByteWriter bytes_;
};

struct BondArrays {
  std::vector<std::int64_t> ends, offsets;
  std::vector<std::uint8_t> types, broken;
  std::vector<double> strain;
  std::vector<std::uint32_t> material;
};

BondArrays bondArrays(const sim::Network& network, const sim::Snapshot& frame) {
  BondArrays arrays;
  arrays.types.assign(network.bondCount(), kLine);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      const sim::NodeIndex b = network.bondEnds[bond];
      arrays.ends.insert(arrays.ends.end(), {a, b});
      arrays.offsets.push_back(static_cast<std::int64_t>(arrays.ends.size()));
      const double length = (frame.positions[b] - frame.positions[a]).norm();
      arrays.strain.push_back(length / network.bond(bond).restLength - 1.0);
      arrays.broken.push_back(frame.broken->hasLostBond(bond) ? 1 : 0);
      arrays.material.push_back(network.bond(bond).material);
    }
  }
  return arrays;
}

sim::Status writeGrid(const std::filesystem::path& path, const sim::Network& network,
                      const sim::Snapshot& frame) {
  const BondArrays bonds = bondArrays(network, frame);
  Appended data;
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  const std::vector<double> time{frame.time};
  xml +=
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"appended\" offset=\"0\"/>\n</FieldData>\n";
  data.add("TimeValue", "Float64", 1, time);
  xml += "<Piece NumberOfPoints=\"" + std::to_string(network.nodeCount()) + "\" NumberOfCells=\"" +
         std::to_string(network.bondCount()) + "\">\n<Points>\n" +
         data.add("position", "Float64", 3, frame.positions) + "</Points>\n<Cells>\n" +
         data.add("connectivity", "Int64", 1, bonds.ends) + data.add("offsets", "Int64", 1, bonds.offsets) +
         data.add("types", "UInt8", 1, bonds.types) + "</Cells>\n<PointData>\n" +
         data.add("velocity", "Float64", 3, frame.velocities) +
         data.add("fragment", "UInt32", 1, frame.broken->fragmentOfNode) +
         data.add("damage", "Float64", 1, damageOfNodes(network, frame)) + "</PointData>\n<CellData>\n" +
         data.add("strain", "Float64", 1, bonds.strain) + data.add("broken", "UInt8", 1, bonds.broken) +
         data.add("material", "UInt32", 1, bonds.material) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  TextOutput out(path);
  out << xml << data.text() << "\n</AppendedData>\n</VTKFile>\n";
  return out.finish();
}

/// The file names are looked for beside the collection's.
std::string entryOf(const std::filesystem::path& path) {
  std::string name;
  for (const char letter : path.filename().string()) {
    if (letter == '&')
      name += "&amp;";
    else if (letter == '<')
      name += "&lt;";
    else if (letter == '"')
      name += "&quot;";
    else
      name += letter;
  }
  return name;
}

}  // namespace

sim::Status writeVtk(const sim::TakeReader& take, const ExportRequest& request) {
  ExportRequest grids = request;
  grids.path.replace_extension(".vtu");
  std::filesystem::path collection = request.path;
  TextOutput out(collection.replace_extension(".pvd"));
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<Collection>\n";
  const auto status = forEachFrame(take, grids, [&](std::size_t index, const sim::Snapshot& frame) {
    const std::filesystem::path path = framePath(grids, index);
    out << "<DataSet timestep=\"" << frame.time << "\" part=\"0\" file=\"" << entryOf(path) << "\"/>\n";
    return writeGrid(path, take.network(), frame);
  });
  if (!status) return status;
  out << "</Collection>\n</VTKFile>\n";
  return out.finish();
}

}  // namespace modeling
