#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/editors/glue_preview.h"
#include "ui/session/background_worker.h"
#include "ui/session/session.h"

namespace ui {

/// One gluing being made or changed: which parts, how far it reaches, which nodes stay out, and what it does,
/// which is found out in a thread of its own. A new one is in the scene when glue() puts it there; one that
/// was in the scene is edited as it stands.
class GlueEditing : public QObject {
  Q_OBJECT

 public:
  enum class Stage {
    off,
    chooseA,  ///< the part whose nodes are dropped
    chooseB,
    adjust,
  };

  explicit GlueEditing(Session& session, QObject* parent = nullptr);

  Stage stage() const { return stage_; }
  /// What is shown and changed; of the scene where isExisting().
  const modeling::Gluing& gluing() const { return gluing_; }
  bool isExisting() const { return existing_.has_value(); }
  /// What the gluing does; null until it is known.
  const std::shared_ptr<const GlueOutcome>& outcome() const { return outcome_; }
  bool isBusy() const { return worker_.isBusy(); }

  /// Starts with the gluing that is selected, or the only one of the part that is, or the two parts that are,
  /// or by asking for parts.
  void begin();
  void edit(std::size_t gluing);
  void choose(const std::string& part);
  void end();

  void setReach(double reach, bool finished);
  /// Takes the nearest two nodes into reach.
  void reachNearest();
  /// Takes a link out, or puts one that was taken out back.
  void toggle(modeling::NodeIndex nodeOfA);
  /// Glues only nodes of part A in this box, in its coordinates; all in reach without one.
  void setRegion(const std::optional<modeling::Box>& region);
  /// Glues B to A instead.
  void swap();
  /// Puts a new gluing into the scene.
  void glue();
  /// Takes one of the scene's away.
  void remove();

 signals:
  void changed();

 private:
  void follow();
  void request();
  void poll();
  void change(const QString& name, const std::function<void(modeling::Gluing&)>& change,
              const QString& gesture = {});
  double usualReach() const;

  struct Request {
    modeling::Scene scene;
    std::size_t gluing = 0;
    std::filesystem::path folder;
  };

  Session& session_;
  Stage stage_ = Stage::off;
  modeling::Gluing gluing_;
  std::optional<std::size_t> existing_;
  std::size_t glueCount_ = 0;  ///< gluings of the scene, where `existing_` is one of them
  std::shared_ptr<const GlueOutcome> outcome_;
  QTimer timer_;
  BackgroundWorker<Request, GlueOutcome> worker_;
};

}  // namespace ui
