// What can be written in a scene file can be seen and changed in the window.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_form.h"
#include "ui/session/session.h"

using namespace ui;

namespace {

using Paths = std::set<QString>;
using Reasons = std::map<QString, const char*>;

constexpr const char* kInHead = "the name is edited in the head of the panel and in the outliner";
constexpr const char* kInOutliner = "each has a row of the outliner, and properties of its own";
constexpr const char* kByIcons = "the eye and the lock in the outliner's rows";
constexpr const char* kKind = "it is chosen when the thing is added, since kinds have no fields in common";

const Reasons kScene{{"smithereens", "the version of the format is no choice"},
                     {"name", kInHead},
                     {"materials", kInOutliner},
                     {"parts", kInOutliner},
                     {"glue", kInOutliner},
                     {"environment.colliders", kInOutliner},
                     {"tracks", kInOutliner},
                     {"view.hidden", kByIcons},
                     {"view.locked", kByIcons}};
const Reasons kPart{{"name", kInHead},
                    {"kind", kKind},
                    {"oppositeNet", "its points are dragged in the viewport like those of the net"},
                    {"inside", "the profile editor draws it beside the outer profile"},
                    {"secondRail", "its points are dragged in the viewport like those of the curve"}};
const Reasons kCollider{{"name", kInHead},
                        {"kind", kKind},
                        {"surface.points", "triangles are made by other programs"},
                        {"surface.triangles", "triangles are made by other programs"}};
const Reasons kGluing{{"exclude", "shown and taken back in one row with the pairs"}};

QJsonObject schema() {
  QFile file(QStringLiteral(SMITHEREENS_SOURCE_DIR "/resources/scenes/scene.schema.json"));
  REQUIRE(file.open(QIODevice::ReadOnly));
  return QJsonDocument::fromJson(file.readAll()).object();
}

QJsonObject within(const QJsonObject& object, std::initializer_list<const char*> keys) {
  QJsonObject found = object;
  for (const char* key : keys) found = found[QLatin1String(key)].toObject();
  return found;
}

/// The values that can be written below a node of the schema, by their paths.
void collect(const QJsonObject& node, const QString& path, Paths& paths) {
  const QJsonObject properties = node[QLatin1String("properties")].toObject();
  for (auto property = properties.begin(); property != properties.end(); ++property) {
    // An angle's other spelling.
    if (property.key() == QLatin1String("radians")) continue;
    collect(property->toObject(), path.isEmpty() ? property.key() : path + u'.' + property.key(), paths);
  }
  for (const QJsonValue& choice : node[QLatin1String("anyOf")].toArray()) {
    const QString type = choice[QLatin1String("type")].toString();
    if (type == QLatin1String("object")) {
      collect(choice.toObject(), path, paths);
    } else if (type != QLatin1String("null")) {
      paths.insert(path);
    }
  }
  const QJsonObject member = within(node, {"additionalProperties"});
  // A map, such as that of the types of bonds: one of its members stands for all.
  if (member.contains(QLatin1String("properties")) && path == QLatin1String("bondTypes"))
    return collect(member, path + QStringLiteral(".1"), paths);
  if (properties.isEmpty() && !node.contains(QLatin1String("anyOf"))) paths.insert(path);
}

bool isCovered(const QString& path, const Paths& rows) {
  return std::ranges::any_of(rows, [&](const QString& row) {
    return row == path || row.startsWith(path + u'[') || row.startsWith(path + u'.');
  });
}

/// The window's properties, of a scene with one thing of each kind.
struct Forms {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  Properties properties{session};

  explicit Forms(const modeling::Scene& scene) { session.document().reset(scene, {}); }

  Paths rowsOf(const Item& item) {
    if (item.kind == ItemKind::scene) {
      session.selection().clear();
    } else {
      session.selection().select(item);
    }
    Paths rows;
    const std::string head = properties.form()->itemPath();
    for (const std::string& path : properties.form()->paths())
      rows.insert(QString::fromStdString(head.empty() ? path : path.substr(head.size() + 1)));
    return rows;
  }

  /// Each value has a row or a reason, and no reason is without need.
  void check(const Item& item, const QJsonObject& node, const Reasons& exceptions) {
    Paths wanted;
    collect(node, {}, wanted);
    CHECK(wanted.size() > 2);
    const Paths rows = rowsOf(item);
    for (const QString& path : wanted) {
      INFO("there is no row for " << path.toStdString());
      CHECK(isCovered(path, rows) != exceptions.contains(path));
    }
  }
};

template <class Variant>
std::vector<Variant> oneOfEach() {
  std::vector<Variant> all;
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (all.push_back(std::variant_alternative_t<kIndex, Variant>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
  return all;
}

modeling::Scene sceneOfAll() {
  modeling::Scene scene;
  for (const modeling::PartShape& shape : oneOfEach<modeling::PartShape>()) {
    modeling::Part part;
    part.name = "part " + std::to_string(scene.parts.size());
    part.shape = shape;
    if (auto* network = std::get_if<modeling::NetworkShape>(&part.shape)) network->bondTypes = {{"1", {}}};
    scene.parts.push_back(part);
  }
  for (const modeling::ColliderForm& form : oneOfEach<modeling::ColliderForm>()) {
    modeling::SceneCollider collider;
    collider.name = "collider " + std::to_string(scene.environment.colliders.size());
    collider.form = form;
    scene.environment.colliders.push_back(collider);
  }
  scene.materials.emplace_back().name = "clay";
  scene.glue.push_back({"part 0", "part 1", 1.0, {}, {}, {}});
  scene.tracks.emplace_back().keys.emplace_back();
  return scene;
}

}  // namespace

TEST_CASE("Every value of a scene file is in a form of the window", "[forms]") {
  const QJsonObject root = schema();
  Forms forms(sceneOfAll());
  SECTION("the scene's own") {
    forms.check({}, root, kScene);
  }
  SECTION("of each kind of part") {
    const QJsonArray kinds = within(root, {"properties", "parts", "items"})[QLatin1String("oneOf")].toArray();
    REQUIRE(kinds.size() == qsizetype(std::variant_size_v<modeling::PartShape>));
    for (qsizetype i = 0; i < kinds.size(); ++i)
      forms.check({ItemKind::part, std::size_t(i)}, kinds[i].toObject(), kPart);
  }
  SECTION("of each kind of collider") {
    const QJsonArray kinds = within(root, {"properties", "environment", "properties", "colliders",
                                           "items"})[QLatin1String("oneOf")]
                                 .toArray();
    REQUIRE(kinds.size() == qsizetype(std::variant_size_v<modeling::ColliderForm>));
    for (qsizetype i = 0; i < kinds.size(); ++i)
      forms.check({ItemKind::collider, std::size_t(i)}, kinds[i].toObject(), kCollider);
  }
  SECTION("of a material") {
    forms.check({ItemKind::material, 0}, within(root, {"properties", "materials", "additionalProperties"}),
                {});
  }
  SECTION("of a gluing") {
    forms.check({ItemKind::gluing, 0}, within(root, {"properties", "glue", "items"}), kGluing);
  }
  SECTION("of a track") {
    forms.check({ItemKind::track, 0}, within(root, {"properties", "tracks", "items"}), {});
  }
}

TEST_CASE("The schema that the forms are checked against is that of the program", "[forms]") {
  const QJsonObject own =
      QJsonDocument::fromJson(QByteArray::fromStdString(modeling::sceneSchema())).object();
  CHECK(own == schema());
}

TEST_CASE("A value that has no row is found", "[forms]") {
  Paths wanted;
  collect(QJsonDocument::fromJson(R"({"properties": {"colour": {"type": "string"}}})").object(), {}, wanted);
  CHECK(wanted == Paths{"colour"});
  CHECK_FALSE(isCovered("colour", {"color", "colours.red"}));
  CHECK(isCovered("colour", {"colour[0]"}));
}
