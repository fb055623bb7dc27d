#include "modeling/scene/scene_codec.h"

namespace modeling {

bool Codec<View>::read(JsonReader& reader, const JsonValue& value, View& out, const Rule& rule) {
  return FieldsCodec<View>::read(reader, value, out, rule);
}

Json Codec<View>::write(const View& value, const View& base, const Rule& rule) {
  return FieldsCodec<View>::write(value, base, rule);
}

Json Codec<View>::schema(const Rule& rule) {
  return FieldsCodec<View>::schema(rule);
}

}  // namespace modeling
