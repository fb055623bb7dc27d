#include "modeling/scene/resources.h"
#include "modeling/scene/scene_codec.h"

namespace modeling {
namespace {

/// Stating one of the three ways to break takes back the preset's way.
void keepStatedBreaking(const JsonValue& object, Material& material) {
  const JsonValue* threshold = object.find("threshold");
  const bool mean = threshold != nullptr && threshold->find("mean") != nullptr && material.threshold.mean;
  const bool strength = object.find("strength") != nullptr && material.strength;
  const bool toughness = object.find("fractureToughness") != nullptr && material.fractureToughness;
  if (!mean && !strength && !toughness) return;
  if (!mean) material.threshold.mean.reset();
  if (!strength) material.strength.reset();
  if (!toughness) material.fractureToughness.reset();
}

bool readMaterial(JsonReader& reader, const JsonMember& member, SceneMaterial& out) {
  const Rule rule{member.key, {}, true, {}, false};
  std::vector<std::string> keys = keysOf<Material>();
  keys.emplace_back("preset");
  if (!reader.checkObject(member.value, rule, keys)) return false;
  if (const JsonValue* preset = member.value.find("preset")) {
    if (!Codec<std::string>::read(reader, *preset, out.preset, {"preset", {}, true, {}, false})) return false;
    sim::Result<Material> values = presetMaterial(out.preset);
    if (!values) return reader.fail(preset->position, values.problem().what, values.problem().remedy);
    out.values = std::move(values).value();
  }
  out.values.name = out.name;
  if (!readFields(reader, member.value, out.values)) return false;
  keepStatedBreaking(member.value, out.values);
  return true;
}

}  // namespace

bool Codec<std::vector<SceneMaterial>>::read(JsonReader& reader, const JsonValue& value, Materials& out,
                                             const Rule& rule) {
  if (value.object() == nullptr) return reader.failKind(value, rule, "an object");
  out.clear();
  for (const JsonMember& member : *value.object()) {
    SceneMaterial& material = out.emplace_back();
    material.name = member.key;
    if (!readMaterial(reader, member, material)) return false;
  }
  return true;
}

Json Codec<std::vector<SceneMaterial>>::write(const Materials& value, const Materials&, const Rule&) {
  Json object = Json::object();
  for (const SceneMaterial& material : value) {
    Json written = Json::object();
    Material base;
    if (!material.preset.empty()) {
      setMember(written, "preset", material.preset);
      if (sim::Result<Material> preset = presetMaterial(material.preset)) base = std::move(preset).value();
    }
    writeFields(material.values, base, written);
    setMember(object, material.name, std::move(written));
  }
  return object;
}

Json Codec<std::vector<SceneMaterial>>::schema(const Rule&) {
  Json material = objectSchema();
  addProperty(material, "preset", typeSchema("string"), "A preset that the other keys are laid over.", false);
  addFieldSchemas<Material>(material);
  return mapSchema(material);
}

}  // namespace modeling
