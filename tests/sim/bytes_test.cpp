#include "sim/base/bytes.h"

#include <limits>

#include <catch2/catch.hpp>

namespace {

sim::ByteWriter sample() {
  sim::ByteWriter writer;
  writer.put<std::uint32_t>(7);
  writer.put(sim::Vec3(1.0, -2.0, 0.1));
  writer.putVector(std::vector<double>{1.5, std::numeric_limits<double>::infinity()});
  writer.putVector(std::vector<sim::Vec3>{{1, 2, 3}, {4, 5, 6}});
  writer.putString("cup");
  return writer;
}

struct Sample {
  std::uint32_t number = 1;
  sim::Vec3 point;
  std::vector<double> values;
  std::vector<sim::Vec3> points;
  std::string text;

  void readFrom(sim::ByteReader& reader) {
    reader.read(number);
    reader.read(point);
    reader.readVector(values);
    reader.readVector(points);
    reader.readString(text);
  }
};

}  // namespace

TEST_CASE("bytes come back as the values they were", "[bytes]") {
  const sim::ByteWriter writer = sample();
  sim::ByteReader reader(writer.bytes());
  Sample read;
  read.readFrom(reader);
  CHECK(reader.finished());
  CHECK(read.number == 7);
  CHECK(read.point == sim::Vec3(1.0, -2.0, 0.1));
  CHECK(read.values == std::vector<double>{1.5, std::numeric_limits<double>::infinity()});
  CHECK(read.points == std::vector<sim::Vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(read.text == "cup");
}

TEST_CASE("every shorter piece of a record fails, and what fails reads as nothing", "[bytes]") {
  const sim::ByteWriter writer = sample();
  for (std::size_t length = 0; length < writer.size(); ++length) {
    sim::ByteReader reader(writer.bytes().first(length));
    Sample read;
    read.readFrom(reader);
    CHECK_FALSE(reader.ok());
    CHECK(read.text.empty());
  }
}

TEST_CASE("bytes left over are noticed", "[bytes]") {
  sim::ByteWriter writer = sample();
  writer.put<std::uint8_t>(0);
  sim::ByteReader reader(writer.bytes());
  Sample read;
  read.readFrom(reader);
  CHECK(reader.ok());
  CHECK_FALSE(reader.finished());
}

TEST_CASE("a count larger than what follows it is refused before anything is allocated", "[bytes]") {
  // The second count would overflow to 8 bytes when multiplied by the size of a double.
  const std::uint64_t counts[] = {2, (std::uint64_t{1} << 61) + 1, std::numeric_limits<std::uint64_t>::max()};
  for (const std::uint64_t count : counts) {
    sim::ByteWriter writer;
    writer.put(count);
    writer.put(1.0);
    sim::ByteReader reader(writer.bytes());
    std::vector<double> values{1.0};
    CHECK_FALSE(reader.readVector(values));
    CHECK(values.empty());
    CHECK(values.capacity() <= 1);
    CHECK_FALSE(reader.ok());
  }
}
