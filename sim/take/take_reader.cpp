#include <algorithm>
#include <cassert>

#include "sim/base/text_hash.h"
#include "sim/take/file_take_reader.h"
#include "sim/take/head_codec.h"

namespace sim {
namespace {

std::string numbered(std::size_t frame) {
  return "frame " + std::to_string(frame);
}

}  // namespace

Result<std::unique_ptr<TakeReader>> TakeReader::open(const std::filesystem::path& path) {
  auto file = TakeFile::openToRead(path);
  if (!file) return file.problem();
  auto reader = FileTakeReader::over(std::move(file).value());
  if (!reader) return reader.problem();
  return std::unique_ptr<TakeReader>(std::move(reader).value());
}

Result<std::unique_ptr<FileTakeReader>> FileTakeReader::over(TakeFile file) {
  auto index = scanTake(file);
  if (!index) return index.problem();
  std::unique_ptr<FileTakeReader> reader(new FileTakeReader(std::move(file), std::move(index).value()));
  if (Status read = reader->readBeginning(); !read) return read.problem();
  return reader;
}

Problem FileTakeReader::damaged(const std::string& what, const std::string& remedy) const {
  return Problem{file_.path().string(), what, remedy};
}

Problem FileTakeReader::noSuchFrame(std::size_t frame) const {
  return damaged(
      "there is no " + numbered(frame) + " in this take of " + std::to_string(frameCount()) + " frames", "");
}

Status FileTakeReader::readBeginning() {
  const std::string remedy = "record it again from its scene";
  const auto head = content(0);
  const auto network = content(1);
  if (!head || !network) return damaged("the beginning of the take is damaged", remedy);
  auto header = decodeHead(*head);
  if (!header) return damaged(header.problem().what, header.problem().remedy);
  auto decoded = decodeNetwork(*network);
  if (!decoded) return damaged(decoded.problem().what, remedy);
  header_ = std::move(header).value();
  network_ = std::move(decoded).value();
  size_ = NetworkSize::of(network_);
  firstScene_ = header_.scene;
  if (auto newest = newestScene(index_.scenesFrom(index_.sceneChunks.size()));
      newest && *newest != firstScene_) {
    header_.sceneHash = textHash(*newest);
    header_.scene = std::move(*newest);
  }
  if (index_.outcome != TakeIndex::kNoChunk) outcome_ = textOf(index_.outcome);
  return Done{};
}

std::optional<std::string> FileTakeReader::textOf(std::size_t chunk) const {
  const auto bytes = content(chunk);
  if (!bytes) return std::nullopt;
  ByteReader reader(*bytes);
  std::string text;
  return reader.readString(text) ? std::optional(std::move(text)) : std::nullopt;
}

std::optional<std::string> FileTakeReader::newestScene(const TakeIndex::Scenes& scenes) const {
  for (std::size_t scene = scenes.last; scene-- > scenes.first;) {
    if (auto text = textOf(index_.sceneChunks[scene])) return text;
  }
  return scenes.fromHead ? std::optional(firstScene_) : std::nullopt;
}

Result<std::string> FileTakeReader::sceneOf(std::size_t frame) const {
  if (frame >= frameCount()) return noSuchFrame(frame);
  auto scene = newestScene(index_.scenesFrom(index_.frames[frame].scenes));
  if (!scene) return damaged("the scene of " + numbered(frame) + " is damaged", "");
  return std::move(*scene);
}

std::optional<std::vector<std::byte>> FileTakeReader::content(std::size_t chunk) const {
  const TakeIndex::Chunk& place = index_.chunks[chunk];
  std::vector<std::byte> payload(static_cast<std::size_t>(place.header.payloadBytes));
  if (!file_.read(place.payloadOffset(), payload)) return std::nullopt;
  return openPayload(place.header, payload);
}

double FileTakeReader::frameTime(std::size_t frame) const {
  assert(frame < frameCount());
  return index_.chunks[index_.frames[frame].chunk].header.time;
}

Result<BrokenPointer> FileTakeReader::brokenAt(std::size_t chunk) const {
  {
    const std::lock_guard lock(brokenMutex_);
    if (BrokenPointer held = held_[chunk].lock()) return newest_ = held;
  }
  const auto bytes = content(chunk);
  if (!bytes) return Problem{"", "its record cannot be read", ""};
  auto broken = decodeBreakage(size_, *bytes);
  if (!broken) return broken;
  const std::lock_guard lock(brokenMutex_);
  // Another thread may have read it meanwhile.
  newest_ = held_[chunk].lock();
  if (!newest_) held_[chunk] = newest_ = std::move(broken).value();
  return newest_;
}

Result<Snapshot> FileTakeReader::snapshotAt(const TakeIndex::Frame& place) const {
  const Problem lost{"", "its record cannot be read", ""};
  const auto frame = content(place.chunk);
  if (!frame) return lost;
  const auto broken = brokenAt(place.breakage);
  if (!broken) return broken.problem();
  if (index_.chunks[place.chunk].header.kind == ChunkKind::frame)
    return decodeSnapshot(size_, *frame, *broken);
  const auto sequence = wholeFrameOf(*frame);
  const std::size_t chunk =
      sequence ? chunkOfSequence(index_, *sequence, ChunkKind::frame) : TakeIndex::kNoChunk;
  if (chunk == TakeIndex::kNoChunk) return Problem{"", "the frame it leans on is lost", ""};
  const auto whole = content(chunk);
  if (!whole) return lost;
  return decodeSnapshot(size_, *frame, *whole, *broken);
}

Result<SnapshotPointer> FileTakeReader::frame(std::size_t index) const {
  const std::string remedy = "use the frames before or after it";
  if (index >= frameCount()) return noSuchFrame(index);
  const TakeIndex::Frame& place = index_.frames[index];
  if (place.breakage == TakeIndex::kNoChunk)
    return damaged("what was broken in " + numbered(index) + " is lost", remedy);
  auto snapshot = snapshotAt(place);
  if (!snapshot) return damaged(numbered(index) + " is damaged: " + snapshot.problem().what, remedy);
  return std::make_shared<const Snapshot>(std::move(snapshot).value());
}

Result<std::vector<BreakEvent>> FileTakeReader::eventsOf(std::size_t frame) const {
  if (frame >= frameCount()) return noSuchFrame(frame);
  const TakeIndex::Frame& place = index_.frames[frame];
  std::vector<BreakEvent> all;
  for (std::size_t e = place.firstEvents; e < place.lastEvents; ++e) {
    const auto bytes = content(index_.eventChunks[e]);
    if (!bytes) return damaged("the record of breaks before " + numbered(frame) + " is damaged", "");
    const auto events = decodeEvents(size_, *bytes);
    if (!events) return damaged(numbered(frame) + ": " + events.problem().what, "");
    all.insert(all.end(), events->begin(), events->end());
  }
  return all;
}

Result<std::vector<BreakEvent>> FileTakeReader::events() const {
  std::vector<BreakEvent> all;
  for (std::size_t frame = 0; frame < frameCount(); ++frame) {
    const auto events = eventsOf(frame);
    if (!events) return events;
    all.insert(all.end(), events->begin(), events->end());
  }
  return all;
}

std::vector<std::size_t> FileTakeReader::checkpointFrames() const {
  std::vector<std::size_t> result;
  for (std::size_t frame = 0; frame < frameCount(); ++frame) {
    if (index_.frames[frame].checkpoint != TakeIndex::kNoChunk) result.push_back(frame);
  }
  return result;
}

std::string FileTakeReader::remedyWithout(std::size_t checkpointFrame) const {
  const std::vector<std::size_t> others = checkpointFrames();
  const auto after = std::ranges::lower_bound(others, checkpointFrame);
  if (after == others.begin()) return "run it again from the start";
  return "go on from " + numbered(*(after - 1));
}

Result<std::vector<std::byte>> FileTakeReader::checkpoint(std::size_t frame) const {
  if (frame >= frameCount()) return noSuchFrame(frame);
  const std::size_t chunk = index_.frames[frame].checkpoint;
  if (chunk == TakeIndex::kNoChunk)
    return damaged(numbered(frame) + " has no checkpoint to go on from", remedyWithout(frame));
  auto bytes = content(chunk);
  if (!bytes) return damaged("the checkpoint of " + numbered(frame) + " is damaged", remedyWithout(frame));
  return std::move(*bytes);
}

}  // namespace sim
