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
/// be seen and the scene is shown at rest: glued nodes are one once it runs. Where a gluing fails, the nodes
/// that came nearest stand in red, whatever is chosen. Found in a thread of its own, and only while they can
/// be seen.
class GluePairs : public QObject {
  Q_OBJECT

 public:
  GluePairs(Session& session, Viewport& viewport);

  /// Empty until they are known, and where they are not seen.
  const std::vector<GlueLink>& links() const { return found_.links; }
  /// Of gluings that fail: the two nodes that are nearest, or the middles of both parts.
  const std::vector<GlueLink>& failed() const { return found_.failed; }

 private:
  struct Request {
    modeling::Scene scene;
    std::filesystem::path folder;
    bool all = false;                  ///< links of all gluings, too
    std::vector<std::size_t> failing;  ///< gluings of the scene
  };
  struct Found {
    std::vector<GlueLink> links;
    std::vector<GlueLink> failed;
  };

  bool areSeen() const;
  /// Gluings of the scene that fail, while it is shown at rest.
  std::vector<std::size_t> failing() const;
  void request();
  void poll();
  void draw(Overlay& overlay) const;

  Session& session_;
  Viewport& viewport_;
  Found found_;
  QTimer timer_;
  BackgroundWorker<Request, Found> worker_;
};

}  // namespace ui
