#include "ui/panels/quantity.h"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

using namespace ui;

namespace {

double valueOf(const char* text, Dimension dimension, double shown = 1.0) {
  const Reading reading = readQuantity(QString::fromUtf8(text), dimension, unitFor(dimension, shown));
  INFO(text << ": " << reading.error.toStdString());
  REQUIRE(reading.value);
  return *reading.value;
}

Reading errorOf(const char* text, Dimension dimension = Dimension::length) {
  Reading reading = readQuantity(QString::fromUtf8(text), dimension, unitFor(dimension, 1.0));
  INFO(text);
  CHECK_FALSE(reading.value);
  CHECK_FALSE(reading.error.isEmpty());
  return reading;
}

}  // namespace

TEST_CASE("What people type is read in the units of the scene", "[quantity]") {
  CHECK(valueOf("8.5", Dimension::length) == 8.5);
  CHECK(valueOf("8,5", Dimension::length) == 8.5);
  CHECK(valueOf("2*3 mm", Dimension::length) == Approx(0.6));
  CHECK(valueOf("1.5in", Dimension::length) == Approx(3.81));
  CHECK(valueOf("(3+4)/2", Dimension::length) == 3.5);
  CHECK(valueOf("1/2 in", Dimension::length) == Approx(1.27));
  CHECK(valueOf("1 m + 2 in - 5", Dimension::length) == Approx(100.0 + 5.08 - 5.0));
  CHECK(valueOf("-(1 cm + 2 mm) * 2", Dimension::length) == Approx(-2.4));
  CHECK(valueOf("(1 in / 2 mm) cm", Dimension::length) == Approx(12.7));
  CHECK(valueOf("2^3^2", Dimension::number) == 512.0);
  CHECK(valueOf("1e-3", Dimension::number) == 1e-3);
  CHECK(valueOf("\xe2\x88\x92"
                "2 \xc3\x97 3",
                Dimension::number) == -6.0);
  CHECK(valueOf("90deg", Dimension::angle) == Approx(std::numbers::pi / 2));
  CHECK(valueOf("pi/2 rad", Dimension::angle) == Approx(std::numbers::pi / 2));
  CHECK(valueOf("pi/2 rad", Dimension::degrees) == Approx(90.0));
  CHECK(valueOf("0.25 turn", Dimension::degrees) == 90.0);
  CHECK(valueOf("90", Dimension::angle) == Approx(std::numbers::pi / 2));
  CHECK(valueOf("70 GPa", Dimension::pressure) == Approx(7e11));
  CHECK(valueOf("70", Dimension::pressure, 6e11) == Approx(7e11));
  CHECK(valueOf("3e8 dyn/cm^2", Dimension::pressure) == 3e8);
  CHECK(valueOf("0.75 MPa\xe2\x88\x9am", Dimension::toughness) == Approx(7.5e7));
  CHECK(valueOf("5 g", Dimension::acceleration) == 5 * 981.0);
  CHECK(valueOf("9.81 m/s\xc2\xb2", Dimension::acceleration) == Approx(981.0));
  CHECK(valueOf("6 m/s", Dimension::velocity) == 600.0);
  CHECK(valueOf("5/s", Dimension::rate) == 5.0);
  CHECK(valueOf("2400 kg/m3", Dimension::density) == Approx(2.4));
  CHECK(valueOf("20 %", Dimension::share) == Approx(0.2));
  CHECK(valueOf("20 ms", Dimension::time) == Approx(0.02));
}

TEST_CASE("What means nothing is answered with where and what", "[quantity]") {
  CHECK(errorOf("2**").errorAt == 2);
  CHECK(errorOf("2**").error.contains(u'*'));
  CHECK(errorOf("").errorAt == 0);
  CHECK(errorOf("3 +").errorAt == 3);
  CHECK(errorOf("(3").error.contains("not closed"));
  CHECK(errorOf("3)").errorAt == 1);
  CHECK(errorOf("3 kg").error.contains("mm"));
  CHECK(errorOf("3 kg").errorAt == 2);
  CHECK(errorOf("1/0").error.contains("zero"));
  CHECK(errorOf("3 mm * 2 mm").error.contains("unit"));
  CHECK(errorOf("1/(2 mm)").error.contains("unit"));
  CHECK(errorOf("3 mm cm").error.contains("already"));
  CHECK(errorOf("1.2.3").errorAt == 0);
  CHECK(errorOf("3 cm", Dimension::number).error.contains("no unit"));
  CHECK(errorOf("9^9^9^9").error.contains("finite"));
  CHECK(errorOf("(3 mm)^2").error.contains("powers"));
  errorOf(std::string(100000, '(').c_str());
  errorOf(std::string(100000, '-').c_str());
}

TEST_CASE("A quantity that is shown and typed again is the same", "[quantity]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponents(-5.0, 12.0);
  for (const Dimension dimension :
       {Dimension::number, Dimension::length, Dimension::pressure, Dimension::angle, Dimension::toughness,
        Dimension::density, Dimension::time}) {
    for (int i = 0; i < 300; ++i) {
      const double value = std::pow(10.0, exponents(random)) * (i % 2 == 0 ? 1.0 : -1.0);
      const QString text = quantityText(value, dimension, 12);
      INFO(text.toStdString());
      CHECK(valueOf(text.toUtf8().constData(), dimension, value) == Approx(value).epsilon(1e-10));
    }
  }
  CHECK(quantityText(8.5, Dimension::length) == "8.5 cm");
  CHECK(quantityText(0.1 + 0.2, Dimension::number) == "0.3");
  CHECK(quantityText(3e8, Dimension::pressure) == "30 MPa");
  CHECK(quantityText(43000.0, Dimension::pressure) == "4.3 kPa");
  CHECK(quantityText(-0.0, Dimension::number) == "0");
  CHECK(numberText(6e5, unitsOf(Dimension::length)[0]) == "600000");
}

TEST_CASE("No text is too odd to be read or refused", "[quantity][fuzz]") {
  const QString pieces[] = {"1",
                            "2.5",
                            "e",
                            "e5",
                            "+",
                            "-",
                            "*",
                            "/",
                            "^",
                            "(",
                            ")",
                            " ",
                            "mm",
                            "cm",
                            "m",
                            "in",
                            "pi",
                            "g",
                            "deg",
                            "rad",
                            ".",
                            ",",
                            "\"",
                            "GPa",
                            "%",
                            "sqrt",
                            QString(QChar(0)),
                            QString(QChar(0xd800)),
                            "1/s",
                            "/s",
                            "\n",
                            "1e999",
                            "0"};
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> piece(0, std::size(pieces) - 1);
  std::uniform_int_distribution<int> length(0, 14);
  std::uniform_int_distribution<int> dimensions(0, static_cast<int>(Dimension::damping));
  for (int i = 0; i < 40000; ++i) {
    QString text;
    for (int n = length(random); n > 0; --n) text += pieces[piece(random)];
    const auto dimension = static_cast<Dimension>(dimensions(random));
    const Reading reading = readQuantity(text, dimension, unitFor(dimension, 1.0));
    INFO(text.toStdString());
    REQUIRE(reading.value.has_value() == reading.error.isEmpty());
    if (reading.value) REQUIRE(std::isfinite(*reading.value));
    REQUIRE((reading.errorAt >= 0 && reading.errorAt <= text.size()));
  }
}
