#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <vector>

#include "ui/editors/glue_preview.h"
#include "ui/session/background_worker.h"
#include "ui/session/session.h"

namespace ui {

class Overlay;
class Viewport;

/// The pairs of nodes that all gluings of the scene join, as lines in the viewport, where glue is chosen to
/// be seen and the scene is shown at rest: glued nodes are one once it runs. Found in a thread of its own,
/// and only while they can be seen.
class GluePairs : public QObject {
  Q_OBJECT

 public:
  GluePairs(Session& session, Viewport& viewport);

  /// Empty until they are known, and where they are not seen.
  const std::vector<GlueLink>& links() const { return links_; }

 private:
  struct Request {
    modeling::Scene scene;
    std::filesystem::path folder;
  };

  bool areSeen() const;
  void request();
  void poll();
  void draw(Overlay& overlay) const;

  Session& session_;
  Viewport& viewport_;
  std::vector<GlueLink> links_;
  QTimer timer_;
  BackgroundWorker<Request, std::vector<GlueLink>> worker_;
};

}  // namespace ui
