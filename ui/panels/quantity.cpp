#include "ui/panels/quantity.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double kRadian = 180.0 / std::numbers::pi;
/// cm/s^2; as the scene's own default, so that 1 g is exactly that.
constexpr double kGravity = 981.0;

constexpr Unit kNone[] = {{"", 1.0}};
constexpr Unit kShare[] = {{"%", 0.01}};
constexpr Unit kLength[] = {{"cm", 1.0}, {"mm", 0.1}, {"m", 100.0}, {"in", 2.54}, {"\"", 2.54}, {"µm", 1e-4}};
constexpr Unit kMass[] = {{"g", 1.0}, {"kg", 1000.0}, {"mg", 1e-3}};
constexpr Unit kTime[] = {{"s", 1.0}, {"ms", 1e-3}, {"µs", 1e-6}, {"us", 1e-6}, {"min", 60.0}};
constexpr Unit kRate[] = {{"1/s", 1.0}, {"/s", 1.0}, {"Hz", 1.0}};
constexpr Unit kVelocity[] = {{"cm/s", 1.0}, {"m/s", 100.0}, {"mm/s", 0.1}, {"km/h", 1e5 / 3600.0}};
constexpr Unit kAcceleration[] = {{"cm/s²", 1.0},  {"cm/s2", 1.0},   {"cm/s^2", 1.0}, {"m/s²", 100.0},
                                  {"m/s2", 100.0}, {"m/s^2", 100.0}, {"g", kGravity}};
constexpr Unit kAngle[] = {{"°", 1.0 / kRadian},
                           {"deg", 1.0 / kRadian},
                           {"rad", 1.0},
                           {"turns", 2.0 * std::numbers::pi},
                           {"turn", 2.0 * std::numbers::pi}};
constexpr Unit kDegrees[] = {{"°", 1.0}, {"deg", 1.0}, {"rad", kRadian}, {"turns", 360.0}, {"turn", 360.0}};
constexpr Unit kAngularVelocity[] = {{"rad/s", 1.0},
                                     {"°/s", 1.0 / kRadian},
                                     {"deg/s", 1.0 / kRadian},
                                     {"turns/s", 2.0 * std::numbers::pi},
                                     {"turn/s", 2.0 * std::numbers::pi},
                                     {"rpm", std::numbers::pi / 30.0}};
constexpr Unit kDensity[] = {{"g/cm³", 1.0},   {"g/cm3", 1.0},   {"g/cm^3", 1.0},
                             {"kg/m³", 0.001}, {"kg/m3", 0.001}, {"kg/m^3", 0.001}};
constexpr Unit kPressure[] = {{"MPa", 1e7},     {"GPa", 1e10},    {"kPa", 1e4},      {"Pa", 10.0},
                              {"dyn/cm²", 1.0}, {"dyn/cm2", 1.0}, {"dyn/cm^2", 1.0}, {"bar", 1e6}};
constexpr Unit kToughness[] = {
    {"MPa√m", 1e8}, {"MPa*sqrt(m)", 1e8}, {"MPa m^0.5", 1e8}, {"kPa√m", 1e5}, {"dyn/cm^1.5", 1.0}};
constexpr Unit kStiffness[] = {{"dyn/cm", 1.0}, {"N/m", 1000.0}, {"N/cm", 1e5}};
constexpr Unit kDamping[] = {{"g/s", 1.0}, {"kg/s", 1000.0}};

/// A number, with or without a unit; with one it is in base units.
struct Value {
  double number = 0.0;
  bool hasUnit = false;
};

QString translated(const char* text) {
  return QCoreApplication::translate("ui::Quantity", text);
}

/// Recursive descent; the first error stops it.
class Reader {
 public:
  Reader(const QString& text, Dimension dimension, const Unit& assumed)
      : text_(text), dimension_(dimension), assumed_(assumed) {}

  Reading read() {
    const Value value = sum();
    skipSpace();
    if (error_.isEmpty() && at_ < text_.size()) failAtRest();
    const double result = inBase(value);
    if (error_.isEmpty() && !std::isfinite(result)) fail(0, translated("this is no finite number"));
    if (!error_.isEmpty()) return {std::nullopt, errorAt_, error_};
    return {result, 0, {}};
  }

 private:
  /// Parentheses within parentheses, and powers of powers: more are no slip but an attack on the stack.
  static constexpr int kMaxDepth = 64;

  Value sum() {
    Value value = product();
    while (!failed()) {
      const QChar sign = accept(u"+-\u2212");
      if (sign.isNull()) break;
      const Value other = product();
      const double second = sign == u'+' ? 1.0 : -1.0;
      if (value.hasUnit || other.hasUnit) {
        value = {inBase(value) + second * inBase(other), true};
      } else {
        value.number += second * other.number;
      }
    }
    return value;
  }

  Value product() {
    Value value = unit(power());
    while (!failed()) {
      const qsizetype start = at_;
      const QChar sign = accept(u"*/\u00d7\u00b7\u00f7");
      if (sign.isNull()) break;
      const Value other = power();
      if (failed()) break;
      value = sign == u'/' || sign == u'\u00f7' ? quotient(value, other, start) : times(value, other, start);
      value = unit(value);
    }
    return value;
  }

  Value times(const Value& a, const Value& b, qsizetype at) {
    if (a.hasUnit && b.hasUnit)
      fail(at, translated("a length times a length is no length: only one factor may have a unit"));
    return {a.number * b.number, a.hasUnit || b.hasUnit};
  }

  Value quotient(const Value& a, const Value& b, qsizetype at) {
    if (b.number == 0.0) fail(at, translated("this divides by zero"));
    if (b.hasUnit && !a.hasUnit)
      fail(at, translated("only something with a unit can be divided by something with a unit"));
    return {a.number / b.number, a.hasUnit && !b.hasUnit};
  }

  Value power() {
    const Value base = signedNumber();
    const qsizetype start = at_;
    if (failed() || accept(u"^").isNull()) return base;
    const Depth depth(*this);
    const Value exponent = power();
    if (!failed() && (base.hasUnit || exponent.hasUnit))
      fail(start, translated("only plain numbers have powers"));
    return {std::pow(base.number, exponent.number), false};
  }

  Value signedNumber() {
    bool negative = false;
    for (QChar sign = accept(u"+-\u2212"); !sign.isNull(); sign = accept(u"+-\u2212"))
      negative = negative != (sign != u'+');
    Value value = primary();
    if (negative) value.number = -value.number;
    return value;
  }

  Value primary() {
    const Depth depth(*this);
    if (failed()) return {};
    if (!accept(u"(").isNull()) {
      const qsizetype opened = at_ - 1;
      const Value inside = sum();
      if (!failed() && accept(u")").isNull())
        fail(at_ < text_.size() ? at_ : opened, translated("the parenthesis is not closed"));
      return inside;
    }
    if (acceptWord(u"pi") || !accept(u"\u03c0").isNull()) return {std::numbers::pi, false};
    return {number(), false};
  }

  double number() {
    skipSpace();
    const qsizetype start = at_;
    while (at_ < text_.size() && (isDigit(at_) || text_[at_] == u'.' || text_[at_] == u',')) ++at_;
    if (at_ == start) {
      fail(start, start < text_.size() ? translated("a number is missing before “%1”").arg(text_[start])
                                       : translated("a number is missing at the end"));
      return 0.0;
    }
    acceptExponent();
    QString digits = text_.mid(start, at_ - start);
    digits.replace(u',', u'.');
    bool valid = false;
    const double value = digits.toDouble(&valid);
    if (!valid) fail(start, translated("“%1” is no number").arg(digits));
    return value;
  }

  /// "1e3", but not the e of a unit.
  void acceptExponent() {
    if (at_ >= text_.size() || text_[at_].toLower() != u'e') return;
    qsizetype end = at_ + 1;
    if (end < text_.size() && (text_[end] == u'+' || text_[end] == u'-')) ++end;
    if (end >= text_.size() || !isDigit(end)) return;
    while (end < text_.size() && isDigit(end)) ++end;
    at_ = end;
  }

  Value unit(const Value& value) {
    skipSpace();
    if (failed() || at_ >= text_.size()) return value;
    const Unit* longest = nullptr;
    qsizetype length = 0;
    for (const Unit& candidate : unitsOf(dimension_)) {
      const QString symbol = QString::fromUtf8(candidate.symbol);
      if (symbol.size() <= length || !startsUnit(symbol)) continue;
      longest = &candidate;
      length = symbol.size();
    }
    if (!longest) return value;
    if (value.hasUnit) {
      fail(at_, translated("there is a unit already"));
      return value;
    }
    at_ += length;
    return {value.number * longest->inBase, true};
  }

  bool startsUnit(const QString& symbol) const {
    if (!QStringView(text_).mid(at_).startsWith(symbol)) return false;
    const qsizetype end = at_ + symbol.size();
    return end >= text_.size() || !symbol.back().isLetter() || !text_[end].isLetterOrNumber();
  }

  void failAtRest() {
    if (text_[at_] == u')') return fail(at_, translated("this parenthesis was not opened"));
    qsizetype end = at_;
    while (end < text_.size() && text_[end].isLetter()) ++end;
    if (end == at_) return fail(at_, translated("“%1” is not expected here").arg(text_[at_]));
    const QString word = text_.mid(at_, end - at_);
    QStringList known;
    for (const Unit& candidate : unitsOf(dimension_)) known << QString::fromUtf8(candidate.symbol);
    known.removeAll(QString());
    fail(at_, known.isEmpty()
                  ? translated("“%1” is not expected here: this number has no unit").arg(word)
                  : translated("“%1” is no unit of this; there are %2").arg(word, known.join(u", ")));
  }

  double inBase(const Value& value) const {
    return value.hasUnit ? value.number : value.number * assumed_.inBase;
  }

  bool isDigit(qsizetype place) const { return text_[place] >= u'0' && text_[place] <= u'9'; }

  void skipSpace() {
    while (at_ < text_.size() && text_[at_].isSpace()) ++at_;
  }

  QChar accept(QStringView characters) {
    skipSpace();
    if (failed() || at_ >= text_.size() || !characters.contains(text_[at_])) return {};
    return text_[at_++];
  }

  bool acceptWord(QStringView word) {
    skipSpace();
    const qsizetype end = at_ + word.size();
    if (QStringView(text_).mid(at_, word.size()).compare(word, Qt::CaseInsensitive) != 0) return false;
    if (end < text_.size() && text_[end].isLetterOrNumber()) return false;
    at_ = end;
    return true;
  }

  bool failed() const { return !error_.isEmpty(); }
  void fail(qsizetype at, const QString& what) {
    if (failed()) return;
    errorAt_ = at;
    error_ = what;
  }

  /// Counts how deep the descent is.
  class Depth {
   public:
    explicit Depth(Reader& reader) : reader_(reader) {
      if (++reader_.depth_ > kMaxDepth) reader_.fail(reader_.at_, translated("this is nested too deeply"));
    }
    ~Depth() { --reader_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    Reader& reader_;
  };

  const QString& text_;
  Dimension dimension_;
  const Unit& assumed_;
  qsizetype at_ = 0;
  int depth_ = 0;
  qsizetype errorAt_ = 0;
  QString error_;
};

}  // namespace

std::span<const Unit> unitsOf(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return kNone;
    case Dimension::share:
      return kShare;
    case Dimension::length:
      return kLength;
    case Dimension::mass:
      return kMass;
    case Dimension::time:
      return kTime;
    case Dimension::rate:
      return kRate;
    case Dimension::velocity:
      return kVelocity;
    case Dimension::acceleration:
      return kAcceleration;
    case Dimension::angle:
      return kAngle;
    case Dimension::degrees:
      return kDegrees;
    case Dimension::angularVelocity:
      return kAngularVelocity;
    case Dimension::density:
      return kDensity;
    case Dimension::pressure:
      return kPressure;
    case Dimension::toughness:
      return kToughness;
    case Dimension::stiffness:
      return kStiffness;
    case Dimension::damping:
      return kDamping;
  }
  return kNone;
}

const Unit& unitFor(Dimension dimension, double value) {
  const double size = std::abs(value);
  if (dimension == Dimension::pressure) {
    if (size >= 1e10) return kPressure[1];
    return size >= 1e7 || size == 0.0 ? kPressure[0] : kPressure[2];
  }
  if (dimension == Dimension::time && size > 0.0 && size < 1e-3) return size < 1e-6 ? kTime[2] : kTime[1];
  return unitsOf(dimension).front();
}

Reading readQuantity(const QString& text, Dimension dimension, const Unit& assumed) {
  return Reader(text, dimension, assumed).read();
}

QString numberText(double value, const Unit& unit, int digits) {
  const double number = value / unit.inBase;
  if (number == 0.0) return QStringLiteral("0");
  const double size = std::abs(number);
  if (size >= 1e7 || size < 1e-4) {
    QString text = QString::number(number, 'g', digits);
    return text.replace(QStringLiteral("e+0"), QStringLiteral("e"))
        .replace(QStringLiteral("e-0"), QStringLiteral("e-"));
  }
  const int before = std::max(1, static_cast<int>(std::floor(std::log10(size))) + 1);
  QString text = QString::number(number, 'f', std::max(0, digits - before));
  if (!text.contains(u'.')) return text;
  while (text.endsWith(u'0')) text.chop(1);
  if (text.endsWith(u'.')) text.chop(1);
  return text == QStringLiteral("-0") ? QStringLiteral("0") : text;
}

QString quantityText(double value, Dimension dimension, int digits) {
  const Unit& unit = unitFor(dimension, value);
  const QString symbol = QString::fromUtf8(unit.symbol);
  const QString number = numberText(value, unit, digits);
  if (symbol.isEmpty()) return number;
  return symbol == QStringLiteral("°") ? number + symbol : number + u' ' + symbol;
}

}  // namespace ui
