#pragma once

namespace ui {

/// A widget in which something may be typed that counts only when it is confirmed. So that it is not lost
/// with the program either, it can be asked what it would come to (Document::rehearse()).
class PendingEdit {
 public:
  virtual ~PendingEdit() = default;
  /// Edits the document as if what is typed were confirmed, and stays as it is. Nothing where nothing is
  /// typed, or what is typed means nothing yet.
  virtual void rehearse() = 0;

 protected:
  PendingEdit() = default;
  PendingEdit(const PendingEdit&) = default;
  PendingEdit& operator=(const PendingEdit&) = default;
};

}  // namespace ui
