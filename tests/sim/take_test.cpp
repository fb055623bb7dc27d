#include "sim/take/take.h"

#include <array>
#include <limits>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include "sim/base/text_hash.h"
#include "sim/take/frame_codec.h"
#include "sim/take/head_codec.h"
#include "tests/sim/take_sample.h"
#include "tests/support/change_broken.h"
#include "tests/support/grid_network.h"

using namespace tests;

namespace {

void record(const std::filesystem::path& path, const sim::Network& network, std::size_t frames) {
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  REQUIRE(writer.ok());
  REQUIRE(appendSample(**writer, network, 0, frames).ok());
  REQUIRE((*writer)->finish("done").ok());
}

bool identical(const sim::Network& a, const sim::Network& b) {
  const sim::ByteWriter bytesOfA = sim::encodeNetwork(a);
  const sim::ByteWriter bytesOfB = sim::encodeNetwork(b);
  return std::ranges::equal(bytesOfA.bytes(), bytesOfB.bytes());
}

}  // namespace

TEST_CASE("a take gives back what was recorded, bit for bit, in any order", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(3, 2, 4);
  const auto path = folder.file("block.take");
  record(path, network, 20);

  auto opened = sim::TakeReader::open(path);
  REQUIRE(opened.ok());
  const sim::TakeReader& take = **opened;
  CHECK(take.header() == sampleHeader());
  CHECK(identical(take.network(), network));
  CHECK(take.network().firstBond == network.firstBond);
  CHECK(take.network().bondEnds == network.bondEnds);
  CHECK(take.network().cells == network.cells);
  CHECK(take.network().positions == network.positions);
  CHECK(take.network().materials == network.materials);
  CHECK(take.network().classes == network.classes);
  CHECK(take.outcome() == "done");
  CHECK(take.droppedBytes() == 0);
  REQUIRE(take.frameCount() == 20);
  for (std::size_t i = 0; i < 20; ++i) {
    const std::size_t frame = 7 * i % 20;
    const sim::Snapshot expected = sampleFrame(network, frame);
    const auto read = take.frame(frame);
    REQUIRE(read.ok());
    CHECK(identical(**read, expected));
    CHECK((*read)->positions == expected.positions);
    CHECK((*read)->velocities == expected.velocities);
    CHECK((*read)->broken->fragmentOfNode == expected.broken->fragmentOfNode);
    CHECK((*read)->broken->bonds == expected.broken->bonds);
    CHECK((*read)->broken->cells == expected.broken->cells);
    CHECK((*read)->broken->version == expected.broken->version);
    CHECK((*read)->fragments.size() == expected.fragments.size());
    CHECK((*read)->ledger.energy.residual == 1e-17);
    CHECK(take.frameTime(frame) == expected.time);
    const auto events = take.eventsOf(frame);
    REQUIRE(events.ok());
    CHECK(identical(*events, sampleEvents(network, frame)));
  }
  CHECK(take.checkpointFrames() == std::vector<std::size_t>{0, 4, 8, 12, 16});
  const auto checkpoint = take.checkpoint(12);
  REQUIRE(checkpoint.ok());
  CHECK(*checkpoint == sampleCheckpoint(12));
  const auto events = take.events();
  REQUIRE(events.ok());
  CHECK(events->size() == 7);
}

TEST_CASE("what is not there is a problem that says so", "[take]") {
  const ScratchFolder folder;
  const auto path = folder.file("block.take");
  record(path, gridNetwork(1, 1, 2), 6);
  auto take = sim::TakeReader::open(path);
  REQUIRE(take.ok());
  CHECK_FALSE((*take)->frame(6).ok());
  CHECK_FALSE((*take)->eventsOf(6).ok());
  CHECK_FALSE((*take)->checkpoint(6).ok());
  const auto checkpoint = (*take)->checkpoint(5);
  REQUIRE_FALSE(checkpoint.ok());
  CHECK(checkpoint.problem().line() ==
        path.string() + ": frame 5 has no checkpoint to go on from; go on from frame 4");

  CHECK_FALSE(sim::TakeReader::open(folder.file("nothing.take")).ok());
  writeBytes(folder.file("scene.take"), {'{', '}'});
  const auto scene = sim::TakeReader::open(folder.file("scene.take"));
  REQUIRE_FALSE(scene.ok());
  CHECK(scene.problem().what == "this is not a take, or nothing of it is left");
  CHECK_FALSE(sim::TakeReader::open(folder.file(".")).ok());
}

TEST_CASE("doubles of every kind survive a frame", "[take]") {
  const sim::Network network = gridNetwork(1, 1, 1);
  sim::Snapshot frame = sampleFrame(network, 3);
  const double limits[] = {-0.0, std::numeric_limits<double>::denorm_min(),
                           std::numeric_limits<double>::max(), -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t i = 0; i < std::size(limits); ++i) frame.velocities[i].setConstant(limits[i]);
  const sim::NetworkSize size = sim::NetworkSize::of(network);
  const auto broken = sim::decodeBreakage(size, sim::encodeBreakage(*frame.broken).bytes());
  REQUIRE(broken.ok());
  const auto decoded = sim::decodeSnapshot(size, sim::encodeFrame(frame).bytes(), *broken);
  REQUIRE(decoded.ok());
  CHECK(identical(*decoded, frame));
}

TEST_CASE("what did not break is stored once", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(8, 8, 8);
  const auto path = folder.file("block.take");
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  REQUIRE(writer.ok());
  sim::Snapshot frame = sampleFrame(network, 9);
  REQUIRE((*writer)->appendFrame(frame, {}).ok());
  const auto once = std::filesystem::file_size(path);
  REQUIRE((*writer)->appendFrame(frame, {}).ok());
  const auto same = std::filesystem::file_size(path) - once;
  tests::changeBroken(frame, [](sim::Broken& broken) { broken.bonds[3] ^= 1; });
  REQUIRE((*writer)->appendFrame(frame, {}).ok());
  const auto changed = std::filesystem::file_size(path) - once - same;
  CHECK(same < changed);
  auto take = sim::TakeReader::open(path);
  REQUIRE(take.ok());
  CHECK((*take)->frame(0).value()->broken->version == (*take)->frame(1).value()->broken->version);
  CHECK((*take)->frame(1).value()->broken->version != (*take)->frame(2).value()->broken->version);
  CHECK((*take)->frame(1).value()->broken->bonds != (*take)->frame(2).value()->broken->bonds);
}

TEST_CASE("frames share what is broken where nothing broke between them, in whatever order they are read",
          "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(3, 3, 3);
  record(folder.file("block.take"), network, 20);
  const auto take = sim::TakeReader::open(folder.file("block.take"));
  REQUIRE(take.ok());
  std::vector<std::size_t> order(20);
  for (std::size_t frame = 0; frame < order.size(); ++frame) order[frame] = frame;
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    std::map<std::size_t, sim::SnapshotPointer> read;
    for (const std::size_t frame : order) read[frame] = (*take)->frame(frame).value();
    for (std::size_t a = 0; a < order.size(); ++a) {
      CHECK(read[a]->broken->version == sampleFrame(network, a).broken->version);
      for (std::size_t b = 0; b < a; ++b) {
        // Frames 1 to 3 are of one state of breaking, 4 to 6 of the next.
        const bool same = (a + 2) / 3 == (b + 2) / 3;
        CHECK((read[a]->broken == read[b]->broken) == same);
        CHECK((read[a]->broken->version == read[b]->broken->version) == same);
      }
    }
  }
}

TEST_CASE("what did not move is left out, and read back all the same", "[take]") {
  // As a heap does: one node after the other comes to rest. Or none ever does.
  const auto frameOf = [](const sim::Network& network, std::size_t number, bool rests) {
    sim::Snapshot frame = sampleFrame(network, number);
    if (!rests) return frame;
    const sim::Snapshot rest = sampleFrame(network, 0);
    const std::size_t resting = std::min(network.nodeCount(), number * network.nodeCount() / 40);
    std::copy_n(rest.positions.begin(), resting, frame.positions.begin());
    std::copy_n(rest.velocities.begin(), resting, frame.velocities.begin());
    return frame;
  };
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(8, 8, 8);
  constexpr std::size_t kFrames = 60;
  std::array<std::uintmax_t, 2> bytes{};
  for (const bool rests : {false, true}) {
    const auto path = folder.file(rests ? "rests.take" : "moves.take");
    auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
    REQUIRE(writer.ok());
    for (std::size_t number = 0; number < kFrames; ++number)
      REQUIRE((*writer)->appendFrame(frameOf(network, number, rests), {}).ok());
    // Whole frames are the 0th and those a multiple of 24 later; from the 5th on an eighth is at rest.
    CHECK(((*writer)->nodesLeftOut() > 0) == rests);
    REQUIRE((*writer)->finish("done").ok());
    bytes[rests ? 1 : 0] = std::filesystem::file_size(path);
    const auto reader = sim::TakeReader::open(path);
    REQUIRE(reader.ok());
    REQUIRE((*reader)->frameCount() == kFrames);
    for (const std::size_t number : {59U, 0U, 7U, 30U, 24U, 23U, 47U, 48U}) {
      const auto frame = (*reader)->frame(number);
      REQUIRE(frame.ok());
      CHECK(identical(**frame, frameOf(network, number, rests)));
    }
  }
  // More than half of all nodes rest, over all frames.
  CHECK(bytes[1] < bytes[0] * 2 / 3);
}

TEST_CASE("a frame that is not of the network is refused and leaves the take as it was", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(2, 2, 2);
  const auto path = folder.file("block.take");
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  REQUIRE(writer.ok());
  CHECK_FALSE((*writer)->appendCheckpoint({}).ok());
  REQUIRE((*writer)->appendFrame(sampleFrame(network, 5), {}).ok());
  const auto size = std::filesystem::file_size(path);

  const auto refused = [&](auto&& spoil) {
    sim::Snapshot frame = sampleFrame(network, 6);
    std::vector<sim::BreakEvent> events(1);
    events[0].bond = events[0].a = events[0].b = 0;
    spoil(frame, events);
    CHECK_FALSE((*writer)->appendFrame(frame, events).ok());
    CHECK(std::filesystem::file_size(path) == size);
  };
  using Events = std::vector<sim::BreakEvent>;
  refused([](sim::Snapshot& frame, Events&) { frame.positions.pop_back(); });
  const auto refusedBroken = [&](const std::function<void(sim::Broken&)>& spoil) {
    refused([&](sim::Snapshot& frame, Events&) { tests::changeBroken(frame, spoil); });
  };
  refusedBroken([](sim::Broken& broken) { broken.bonds.push_back(0); });
  refusedBroken([](sim::Broken& broken) { broken.cells.clear(); });
  refusedBroken([](sim::Broken& broken) { broken.fragmentOfNode[1] = 99; });
  refused([](sim::Snapshot& frame, Events&) { frame.fragments[1].id = 0; });
  refused([](sim::Snapshot& frame, Events&) { frame.fragments.pop_back(); });
  refused([](sim::Snapshot& frame, Events&) {
    frame.fragments[1].id = 0;
    tests::changeBroken(frame, [](sim::Broken& broken) { broken.fragments[1].id = 0; });
  });
  refused([](sim::Snapshot& frame, Events&) { frame.time = 0.0; });
  refused([](sim::Snapshot& frame, Events&) { frame.time = std::numeric_limits<double>::quiet_NaN(); });
  refused([&](sim::Snapshot&, Events& events) {
    events[0].bond = static_cast<sim::BondIndex>(network.bondCount());
  });
  refused([](sim::Snapshot&, Events& events) { events[0].b = sim::kNone; });

  REQUIRE((*writer)->finish("stopped").ok());
  CHECK_FALSE((*writer)->appendFrame(sampleFrame(network, 7), {}).ok());
  CHECK_FALSE((*writer)->finish("done").ok());
  auto take = sim::TakeReader::open(path);
  REQUIRE(take.ok());
  CHECK((*take)->frameCount() == 1);
  CHECK((*take)->outcome() == "stopped");
}

TEST_CASE("a take that goes on after any checkpoint is the take that never stopped", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(3, 2, 2);
  const auto whole = folder.file("whole.take");
  record(whole, network, 13);
  const auto expected = fileBytes(whole);
  for (const std::size_t frame : {0U, 4U, 8U, 12U}) {
    const auto path = folder.file("again.take");
    writeBytes(path, expected);
    auto writer = sim::TakeWriter::continueAfter(path, frame);
    REQUIRE(writer.ok());
    REQUIRE(appendSample(**writer, network, frame + 1, 13).ok());
    REQUIRE((*writer)->finish("done").ok());
    CHECK(fileBytes(path) == expected);
  }
  for (const std::size_t frame : {1U, 13U}) {
    CHECK_FALSE(sim::TakeWriter::continueAfter(whole, frame).ok());
    CHECK(fileBytes(whole) == expected);
  }
}

TEST_CASE("a take knows which scene each frame came from", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(1, 1, 1);
  const auto path = folder.file("performed.take");
  const std::string first = sampleHeader().scene;
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  REQUIRE(writer.ok());
  REQUIRE(appendSample(**writer, network, 0, 2).ok());
  const auto scenes = [&] {
    const auto take = sim::TakeReader::open(path);
    REQUIRE(take.ok());
    CHECK((*take)->droppedBytes() == 0);
    std::vector<std::string> found;
    for (std::size_t frame = 0; frame < (*take)->frameCount(); ++frame)
      found.push_back((*take)->sceneOf(frame).value());
    CHECK_FALSE((*take)->sceneOf((*take)->frameCount()).ok());
    found.push_back((*take)->header().scene);
    CHECK((*take)->header().sceneHash ==
          (found.back() == first ? sampleHeader().sceneHash : sim::textHash(found.back())));
    return found;
  };
  CHECK(scenes() == std::vector{first, first, first});
  // What is added holds for the past as well.
  REQUIRE((*writer)->appendScene("poked").ok());
  REQUIRE((*writer)->appendScene("poked twice").ok());
  const std::string poked = "poked twice";
  CHECK(scenes() == std::vector{poked, poked, poked});
  REQUIRE(appendSample(**writer, network, 2, 5).ok());
  // What is another does not.
  REQUIRE((*writer)->beginScene("other").ok());
  REQUIRE(appendSample(**writer, network, 5, 6).ok());
  REQUIRE((*writer)->appendScene("other, poked").ok());
  const std::string other = "other, poked";
  CHECK(scenes() == std::vector{poked, poked, poked, poked, poked, other, other});

  SECTION("the newest is lost: the one before it is there") {
    REQUIRE((*writer)->beginScene("more").ok());
    writer->reset();
    auto bytes = fileBytes(path);
    bytes.back() ^= 1;
    writeBytes(path, bytes);
    const auto take = sim::TakeReader::open(path);
    REQUIRE(take.ok());
    CHECK((*take)->header().scene == other);
  }
  SECTION("a take that goes on keeps the newest scene of where it goes on") {
    writer->reset();
    writer = sim::TakeWriter::continueAfter(path, 0);
    REQUIRE(writer.ok());
    CHECK(scenes() == std::vector{poked, poked});
  }
  SECTION("nothing comes after the end") {
    REQUIRE((*writer)->finish("done").ok());
    CHECK_FALSE((*writer)->appendScene("late").ok());
    CHECK_FALSE((*writer)->beginScene("late").ok());
  }
}

TEST_CASE("every prefix of a take opens with every frame that is whole in it", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(1, 1, 1);
  const auto path = folder.file("block.take");
  std::vector<std::size_t> ends;
  {
    auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
    REQUIRE(writer.ok());
    ends.push_back(std::filesystem::file_size(path));
    for (std::size_t frame = 0; frame < 5; ++frame) {
      REQUIRE((*writer)->appendFrame(sampleFrame(network, frame), sampleEvents(network, frame)).ok());
      ends.push_back(std::filesystem::file_size(path));
    }
  }
  for (std::size_t size = std::filesystem::file_size(path) + 1; size-- > 0;) {
    std::filesystem::resize_file(path, size);
    auto take = sim::TakeReader::open(path);
    if (size < ends[0]) {
      CHECK_FALSE(take.ok());
      continue;
    }
    REQUIRE(take.ok());
    const auto wholeEnd = std::upper_bound(ends.begin(), ends.end(), size) - 1;
    const auto frames = static_cast<std::size_t>(wholeEnd - ends.begin());
    REQUIRE((*take)->frameCount() == frames);
    CHECK((*take)->droppedBytes() == size - *wholeEnd);
    if (frames > 0) CHECK(identical(**(*take)->frame(frames - 1), sampleFrame(network, frames - 1)));
  }
}

TEST_CASE("damage in the middle costs what it hit and nothing else", "[take]") {
  const ScratchFolder folder;
  const sim::Network network = gridNetwork(2, 2, 2);
  const auto path = folder.file("block.take");
  std::vector<std::size_t> ends;
  auto writer = sim::TakeWriter::create(path, sampleHeader(), network);
  REQUIRE(writer.ok());
  // Nothing breaks between frames 5 and 6, so frame 6 needs only what frame 4 stored.
  for (std::size_t frame = 4; frame < 8; ++frame) {
    ends.push_back(std::filesystem::file_size(path));
    REQUIRE((*writer)->appendFrame(sampleFrame(network, frame), {}).ok());
  }
  REQUIRE(ends.size() == 4);
  const auto bytes = fileBytes(path);
  const auto damaged = folder.file("damaged.take");

  SECTION("a header: the frame is gone, the others are there") {
    auto spoiled = bytes;
    spoiled[ends[1] + 20] ^= 1;
    writeBytes(damaged, spoiled);
    auto take = sim::TakeReader::open(damaged);
    REQUIRE(take.ok());
    CHECK((*take)->droppedBytes() == ends[2] - ends[1]);
    REQUIRE((*take)->frameCount() == 3);
    CHECK(identical(**(*take)->frame(0), sampleFrame(network, 4)));
    CHECK(identical(**(*take)->frame(1), sampleFrame(network, 6)));
    CHECK(identical(**(*take)->frame(2), sampleFrame(network, 7)));
  }
  SECTION("a payload: reading that frame is a problem") {
    auto spoiled = bytes;
    spoiled[ends[2] - 1] ^= 1;
    writeBytes(damaged, spoiled);
    auto take = sim::TakeReader::open(damaged);
    REQUIRE(take.ok());
    REQUIRE((*take)->frameCount() == 4);
    CHECK_FALSE((*take)->frame(1).ok());
    CHECK(identical(**(*take)->frame(2), sampleFrame(network, 6)));
  }
  SECTION("bytes that are missing: what follows is found again") {
    auto spoiled = bytes;
    spoiled.erase(spoiled.begin() + static_cast<std::ptrdiff_t>(ends[1]) + 90);
    writeBytes(damaged, spoiled);
    auto take = sim::TakeReader::open(damaged);
    REQUIRE(take.ok());
    CHECK((*take)->droppedBytes() > 0);
    CHECK(identical(**(*take)->frame((*take)->frameCount() - 1), sampleFrame(network, 7)));
  }
  SECTION("what frames lean on: they say so, the next ones that broke are there") {
    auto spoiled = bytes;
    spoiled[ends[0] + 20] ^= 1;
    writeBytes(damaged, spoiled);
    auto take = sim::TakeReader::open(damaged);
    REQUIRE(take.ok());
    REQUIRE((*take)->frameCount() == 4);
    for (const std::size_t frame : {0U, 1U, 2U}) CHECK_FALSE((*take)->frame(frame).ok());
    CHECK(identical(**(*take)->frame(3), sampleFrame(network, 7)));
  }
}
