#include "ui/panels/number_field.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTest>

#include <catch2/catch.hpp>

#include "ui/panels/plain_fields.h"

using namespace ui;

namespace {

/// Two fields beside each other, as in a panel; keeps what they say.
struct Fields {
  QWidget window;
  NumberField* size;
  NumberField* count;
  std::vector<std::pair<std::optional<double>, bool>> said;

  Fields() {
    NumberFormat length;
    length.dimension = Dimension::length;
    length.least = 1e-4;
    length.step = 0.1;
    NumberFormat counts;
    counts.whole = true;
    counts.least = 1.0;
    counts.step = 1.0;
    counts.autoText = QStringLiteral("auto");
    auto* row = new QHBoxLayout(&window);
    size = new NumberField(length);
    count = new NumberField(counts);
    row->addWidget(size);
    row->addWidget(count);
    size->setValue(8.0);
    size->setDefault(8.0);
    for (NumberField* field : {size, count})
      QObject::connect(
          field, &NumberField::edited, field,
          [this](std::optional<double> value, bool finished) { said.emplace_back(value, finished); });
    window.resize(360, 60);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&window));
  }

  QLineEdit* editor() { return editorIn(window); }
  /// Editors that are closed live on until the event loop comes round.
  static QLineEdit* editorIn(QWidget& widget) {
    for (QLineEdit* each : widget.findChildren<QLineEdit*>(QStringLiteral("number-editor"))) {
      if (each->isVisible()) return each;
    }
    return nullptr;
  }
  void type(const char* text) {
    REQUIRE(editor());
    QTest::keyClicks(editor(), QString::fromUtf8(text));
  }
  void drag(NumberField* field, int pixels, Qt::KeyboardModifiers modifiers = {}) {
    const QPoint start(60, 10);
    QTest::mousePress(field, Qt::LeftButton, modifiers, start);
    for (int x = 1; x <= std::abs(pixels); ++x) {
      const QPointF at = start + QPoint(pixels > 0 ? x : -x, 0);
      QMouseEvent move(QEvent::MouseMove, at, field->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       modifiers);
      QApplication::sendEvent(field, &move);
    }
    QTest::mouseRelease(field, Qt::LeftButton, modifiers, start + QPoint(pixels, 0));
  }
};

}  // namespace

TEST_CASE("A number is clicked, typed with arithmetic, and taken by Enter", "[number-field]") {
  Fields fields;
  QTest::mouseClick(fields.size, Qt::LeftButton, {}, QPoint(60, 10));
  REQUIRE(fields.editor());
  CHECK(fields.editor()->text() == "8 cm");
  fields.type("2*30 mm");
  QTest::keyClick(fields.editor(), Qt::Key_Return);
  CHECK_FALSE(fields.size->isEditing());
  REQUIRE(fields.said.size() == 1);
  CHECK(*fields.said[0].first == Approx(6.0));
  CHECK(fields.said[0].second);
  CHECK(fields.size->hasFocus());
}

TEST_CASE("Esc takes back what is typed, Tab takes it and goes on", "[number-field]") {
  Fields fields;
  QTest::mouseClick(fields.size, Qt::LeftButton, {}, QPoint(60, 10));
  fields.type("3");
  QTest::keyClick(fields.editor(), Qt::Key_Escape);
  CHECK(fields.said.empty());
  CHECK(fields.size->value() == 8.0);

  QTest::keyClick(fields.size, Qt::Key_5);
  REQUIRE(fields.editor());
  QTest::keyClick(fields.editor(), Qt::Key_Tab);
  CHECK(fields.size->value() == 5.0);
  REQUIRE(fields.count->isEditing());
  QTest::keyClick(fields.editor(), Qt::Key_Backtab);
  CHECK_FALSE(fields.count->isEditing());
  CHECK(fields.size->isEditing());
  CHECK(fields.said.size() == 1);
}

TEST_CASE("A text that means nothing keeps the editor open and the value", "[number-field]") {
  Fields fields;
  QTest::mouseClick(fields.size, Qt::LeftButton, {}, QPoint(60, 10));
  for (const char* wrong : {"2**", "-3", "5 kg"}) {
    fields.editor()->selectAll();
    fields.type(wrong);
    QTest::keyClick(fields.editor(), Qt::Key_Return);
    CHECK(fields.size->isEditing());
  }
  CHECK(fields.said.empty());
  fields.count->setFocus();
  CHECK_FALSE(fields.size->isEditing());
  CHECK(fields.size->value() == 8.0);
  CHECK(fields.said.empty());
}

TEST_CASE("A drag changes the number and ends as one edit", "[number-field]") {
  Fields fields;
  fields.drag(fields.size, 60);
  REQUIRE(fields.said.size() > 2);
  CHECK(*fields.size->value() == Approx(9.0));
  for (std::size_t i = 0; i + 1 < fields.said.size(); ++i) CHECK_FALSE(fields.said[i].second);
  CHECK(fields.said.back().second);
  CHECK_FALSE(fields.size->isEditing());

  fields.drag(fields.size, -60, Qt::ShiftModifier);
  CHECK(*fields.size->value() == Approx(8.9));
  fields.drag(fields.size, 31, Qt::ControlModifier);
  CHECK(*fields.size->value() == Approx(9.4));
  fields.drag(fields.size, -2000);
  CHECK(*fields.size->value() > 0.0);
}

TEST_CASE("Esc takes a drag back", "[number-field]") {
  Fields fields;
  QTest::mousePress(fields.size, Qt::LeftButton, {}, QPoint(60, 10));
  QMouseEvent move(QEvent::MouseMove, QPointF(90, 10), fields.size->mapToGlobal(QPointF(90, 10)),
                   Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(fields.size, &move);
  CHECK(*fields.size->value() > 8.0);
  QTest::keyClick(fields.size, Qt::Key_Escape);
  CHECK(fields.size->value() == 8.0);
  CHECK(fields.said.back() == std::pair<std::optional<double>, bool>(8.0, true));
  QTest::mouseRelease(fields.size, Qt::LeftButton, {}, QPoint(90, 10));
  CHECK_FALSE(fields.size->isEditing());
}

TEST_CASE("A double click resets", "[number-field]") {
  Fields fields;
  fields.size->setValue(3.0);
  const QPoint at(60, 10);
  QTest::mouseClick(fields.window.windowHandle(), Qt::LeftButton, {}, fields.size->mapTo(&fields.window, at));
  QTest::mouseDClick(fields.window.windowHandle(), Qt::LeftButton, {},
                     fields.size->mapTo(&fields.window, at));
  CHECK(fields.size->value() == 8.0);
  CHECK_FALSE(fields.size->isEditing());
}

TEST_CASE("A value may be left to the program", "[number-field]") {
  Fields fields;
  fields.count->setAutoValue(24.0);
  QTest::mouseClick(fields.count, Qt::LeftButton, {}, QPoint(60, 10));
  fields.type("17.6");
  QTest::keyClick(fields.editor(), Qt::Key_Return);
  CHECK(fields.count->value() == 18.0);
  QTest::mouseClick(fields.count, Qt::LeftButton, {}, QPoint(60, 10));
  QTest::keyClick(fields.editor(), Qt::Key_Delete);
  QTest::keyClick(fields.editor(), Qt::Key_Return);
  CHECK_FALSE(fields.count->value());
  fields.drag(fields.count, 12);
  CHECK(fields.count->value() == 26.0);
}

TEST_CASE("The wheel counts only in a field that has the focus", "[number-field]") {
  Fields fields;
  const auto turn = [&] {
    QWheelEvent wheel(QPointF(10, 10), fields.size->mapToGlobal(QPointF(10, 10)), {}, QPoint(0, 120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(fields.size, &wheel);
  };
  fields.count->setFocus();
  turn();
  CHECK(fields.size->value() == 8.0);
  fields.size->setFocus();
  turn();
  turn();
  CHECK(*fields.size->value() == Approx(8.2));
  fields.count->setFocus();
  CHECK(fields.said.back().second);
}

TEST_CASE("A line of text counts when it is left, and Esc takes it back", "[number-field]") {
  TextField field;
  field.setValue(QStringLiteral("cup"));
  QStringList said;
  QObject::connect(&field, &TextField::edited, &field, [&](const QString& text) {
    said << text;
    field.setValue(text);
  });
  field.show();
  REQUIRE(QTest::qWaitForWindowExposed(&field));
  QTest::keyClicks(&field, QStringLiteral("s"));
  QTest::keyClick(&field, Qt::Key_Escape);
  CHECK(field.text() == "cup");
  field.end(false);
  QTest::keyClicks(&field, QStringLiteral("s"));
  QTest::keyClick(&field, Qt::Key_Return);
  CHECK(said == QStringList{QStringLiteral("cups")});
  QTest::keyClick(&field, Qt::Key_Return);
  CHECK(said.size() == 1);
}
