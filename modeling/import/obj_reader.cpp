#include "modeling/import/obj_reader.h"

#include <algorithm>
#include <array>

#include "modeling/import/mesh_text.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

class ObjReader {
 public:
  Reading run(std::string_view text) {
    MeshLines lines(text);
    while (lines.next()) {
      line_ = lines.line();
      const std::string place = lines.place();
      while (!line_.empty() && line_.back() == '\\' && lines.next()) {
        line_.back() = ' ';
        line_ += lines.line();
      }
      if (const Status status = take(line_, place); !status) return status.problem();
    }
    if (hasCurves_ && faces_.empty())
      return Problem{"", "it has curved surfaces and no faces", "export it as polygons"};
    if (!isObj_) return Problem{"", "this is no OBJ: there are no corners in it", "export it anew"};
    for (const Face& face : faces_)
      if (const Status status = addPolygon(face.corners, face.place, raw_); !status) return status.problem();
    if (hasCurves_) raw_.addNote("its curved surfaces were passed over");
    return std::move(raw_);
  }

 private:
  struct Face {
    std::vector<std::int64_t> corners;
    std::string place;
  };

  Status take(std::string_view line, const std::string& place) {
    std::string_view rest = line;
    const std::string_view key = nextWord(rest);
    if (key == "v") return takePoint(rest, place);
    if (key == "f" || key == "fo") return takeFace(rest, place);
    if (key == "l") ++raw_.wires;
    if (key == "p") ++raw_.loosePoints;
    if (key == "curv" || key == "curv2" || key == "surf") hasCurves_ = true;
    if (key.starts_with('#')) takeStatement(line.substr(line.find('#') + 1), raw_);
    return sim::Done{};
  }

  Status takePoint(std::string_view rest, const std::string& place) {
    isObj_ = true;
    const auto point = pointOf(rest, place);
    if (!point) return point.problem();
    raw_.points.push_back(*point);
    return sim::Done{};
  }

  /// "corner/texture/normal", counted from 1, or from the last one backwards.
  Status takeFace(std::string_view rest, const std::string& place) {
    Face face{{}, place};
    for (std::string_view word = nextWord(rest); !word.empty() && word.front() != '#';
         word = nextWord(rest)) {
      const auto number = integerOf(word.substr(0, word.find('/')));
      if (!number || *number == 0)
        return Problem{"", place + ": \"" + std::string(word.substr(0, 40)) + "\" names no corner of a face",
                       "export it anew"};
      const auto known = static_cast<std::int64_t>(raw_.points.size());
      face.corners.push_back(*number > 0 ? *number - 1 : known + *number);
    }
    if (face.corners.size() < 3) {
      ++raw_.wires;
      return sim::Done{};
    }
    faces_.push_back(std::move(face));
    return sim::Done{};
  }

  RawMesh raw_;
  std::vector<Face> faces_;  ///< whose corners may come behind them
  std::string line_;         ///< with those that it goes on in
  bool isObj_ = false;
  bool hasCurves_ = false;
};

}  // namespace

Reading readObj(std::string_view text) {
  return ObjReader().run(text);
}

}  // namespace modeling
