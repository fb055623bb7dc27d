#include "modeling/scene/scene_codec.h"

namespace modeling {

bool Codec<Solver>::read(JsonReader& reader, const JsonValue& value, Solver& out, const Rule& rule) {
  return FieldsCodec<Solver>::read(reader, value, out, rule);
}

Json Codec<Solver>::write(const Solver& value, const Solver& base, const Rule& rule) {
  return FieldsCodec<Solver>::write(value, base, rule);
}

Json Codec<Solver>::schema(const Rule& rule) {
  return FieldsCodec<Solver>::schema(rule);
}

}  // namespace modeling
