#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui {

/// How long the window's thread did not come to answer anything: the longest wait between two turns of the
/// event loop, while it is listened to.
class Heartbeat : public QObject {
 public:
  explicit Heartbeat(QObject* parent = nullptr);

  void listen(bool on);
  /// ms, in the last five to ten seconds; the beat itself comes every 5 ms.
  double longestWait() const;

 private:
  void beat();

  QTimer timer_;
  QElapsedTimer last_;
  QElapsedTimer span_;
  double present_ = 0.0;  ///< ms, longest of the span
  double before_ = 0.0;   ///< likewise, of the one before
};

}  // namespace ui
