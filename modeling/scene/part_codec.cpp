#include "modeling/scene/scene_codec.h"

namespace modeling {

using PartCodec = TaggedCodec<Part, PartShape, &Part::shape>;

bool Codec<Part>::read(JsonReader& reader, const JsonValue& value, Part& out, const Rule& rule) {
  return PartCodec::read(reader, value, out, rule);
}

Json Codec<Part>::write(const Part& value, const Part& base, const Rule& rule) {
  return PartCodec::write(value, base, rule);
}

Json Codec<Part>::schema(const Rule& rule) {
  return PartCodec::schema(rule);
}

}  // namespace modeling
