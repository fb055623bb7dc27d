#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/take/chunk.h"
#include "sim/take/file_take_reader.h"
#include "sim/take/frame_codec.h"
#include "sim/take/head_codec.h"
#include "sim/take/take.h"
#include "sim/take/take_file.h"

namespace sim {
namespace {

/// A frame that leans on a whole one is lost with it: not more than these are. Half a second at 48 a second.
constexpr std::uint64_t kFramesPerWhole = 24;
/// Nodes that must be unmoved, one in so many, to be worth a second chunk to read.
constexpr std::size_t kWorthLeaving = 8;

/// What the next append has to know of those before it.
struct Progress {
  std::uint64_t nextSequence = 0;
  std::uint64_t nextFrame = 0;
  double lastTime = -std::numeric_limits<double>::infinity();
  /// Version of what was stored last as broken, and its chunk: kNoBase before the first.
  std::uint64_t brokenVersion = 0;
  std::uint64_t breakageSequence = ChunkHeader::kNoBase;
  /// The last whole frame, its chunk and its number.
  WholeFrame whole;
  std::uint64_t wholeSequence = ChunkHeader::kNoBase;
  std::uint64_t wholeNumber = 0;
};

class FileTakeWriter final : public TakeWriter {
 public:
  FileTakeWriter(TakeFile file, NetworkSize size, Progress progress)
      : file_(std::move(file)), size_(size), progress_(std::move(progress)) {}

  Status appendFrame(const Snapshot& frame, const std::vector<BreakEvent>& eventsSinceLastFrame) override;
  Status appendCheckpoint(const std::vector<std::byte>& checkpoint) override;
  Status appendScene(const std::string& scene) override { return putScene(ChunkKind::scene, scene); }
  Status beginScene(const std::string& scene) override { return putScene(ChunkKind::otherScene, scene); }
  Status finish(const std::string& outcome) override;
  std::uint64_t nodesLeftOut() const override { return nodesLeftOut_; }

 private:
  /// One flag a node: it must be in this frame. Empty: the frame must be whole.
  std::vector<std::uint8_t> nodesToRecord(const Snapshot& frame) const;
  Problem refusal(const std::string& what) const { return Problem{file_.path().string(), what, ""}; }
  Status putScene(ChunkKind kind, const std::string& scene);
  Status appendOne(ChunkKind kind, std::uint64_t frame, std::span<const std::byte> content);

  TakeFile file_;
  NetworkSize size_;
  Progress progress_;
  bool finished_ = false;
  std::uint64_t nodesLeftOut_ = 0;
};

std::vector<std::uint8_t> FileTakeWriter::nodesToRecord(const Snapshot& frame) const {
  const bool leans = progress_.wholeSequence != ChunkHeader::kNoBase &&
                     progress_.nextFrame - progress_.wholeNumber < kFramesPerWhole;
  if (!leans) return {};
  std::vector<std::uint8_t> changed = changedNodes(frame, progress_.whole);
  const auto unmoved = static_cast<std::size_t>(std::ranges::count(changed, std::uint8_t{0}));
  if (kWorthLeaving * unmoved < changed.size() || changed.empty()) return {};
  return changed;
}

Status FileTakeWriter::appendFrame(const Snapshot& frame,
                                   const std::vector<BreakEvent>& eventsSinceLastFrame) {
  if (finished_) return refusal("a frame came after the end of the take");
  if (const auto fault = faultOf(size_, frame)) return refusal("this frame can't be recorded: " + *fault);
  if (const auto fault = faultOf(size_, eventsSinceLastFrame))
    return refusal("this frame can't be recorded: " + *fault);
  if (frame.time < progress_.lastTime)
    return refusal("this frame can't be recorded: it is before the last one");

  // All chunks of the frame go out in one write, the frame last: it seals what it needs.
  ByteWriter out;
  std::uint64_t sequence = progress_.nextSequence;
  std::uint64_t breakageSequence = progress_.breakageSequence;
  const bool broken =
      breakageSequence == ChunkHeader::kNoBase || frame.broken->version != progress_.brokenVersion;
  ChunkHeader header;
  header.frame = progress_.nextFrame;
  header.time = frame.time;
  const auto put = [&](ChunkKind kind, std::span<const std::byte> content) {
    header.kind = kind;
    header.sequence = sequence++;
    appendChunk(out, header, content);
    return header.sequence;
  };
  if (broken) breakageSequence = put(ChunkKind::breakage, encodeBreakage(*frame.broken).bytes());
  if (!eventsSinceLastFrame.empty()) put(ChunkKind::events, encodeEvents(eventsSinceLastFrame).bytes());
  header.base = breakageSequence;
  const std::vector<std::uint8_t> changed = nodesToRecord(frame);
  if (changed.empty()) {
    put(ChunkKind::frame, encodeFrame(frame).bytes());
  } else {
    put(ChunkKind::change, encodeChange(frame, progress_.wholeSequence, changed).bytes());
  }
  if (Status appended = file_.append(out.bytes()); !appended) return appended;

  if (changed.empty()) {
    progress_.whole = {frame.positions, frame.velocities};
    progress_.wholeSequence = header.sequence;
    progress_.wholeNumber = progress_.nextFrame;
  }
  nodesLeftOut_ += static_cast<std::uint64_t>(std::ranges::count(changed, std::uint8_t{0}));
  progress_.nextSequence = sequence;
  ++progress_.nextFrame;
  progress_.lastTime = frame.time;
  progress_.breakageSequence = breakageSequence;
  progress_.brokenVersion = frame.broken->version;
  return Done{};
}

Status FileTakeWriter::appendOne(ChunkKind kind, std::uint64_t frame, std::span<const std::byte> content) {
  ChunkHeader header;
  header.kind = kind;
  header.sequence = progress_.nextSequence;
  header.frame = frame;
  header.time = progress_.nextFrame == 0 ? 0.0 : progress_.lastTime;
  ByteWriter out;
  appendChunk(out, header, content);
  if (Status appended = file_.append(out.bytes()); !appended) return appended;
  ++progress_.nextSequence;
  return Done{};
}

Status FileTakeWriter::appendCheckpoint(const std::vector<std::byte>& checkpoint) {
  if (finished_) return refusal("a checkpoint came after the end of the take");
  if (progress_.nextFrame == 0) return refusal("a checkpoint came before the first frame");
  return appendOne(ChunkKind::checkpoint, progress_.nextFrame - 1, checkpoint);
}

Status FileTakeWriter::putScene(ChunkKind kind, const std::string& scene) {
  if (finished_) return refusal("a scene came after the end of the take");
  ByteWriter content;
  content.putString(scene);
  return appendOne(kind, progress_.nextFrame, content.bytes());
}

Status FileTakeWriter::finish(const std::string& outcome) {
  if (finished_) return refusal("the take has ended already");
  ByteWriter content;
  content.putString(outcome);
  if (Status appended = appendOne(ChunkKind::outcome, progress_.nextFrame, content.bytes()); !appended)
    return appended;
  finished_ = true;
  return file_.sync();
}

/// The whole frame that the next one may lean on: this one, or the one that it leans on.
Status findWhole(const FileTakeReader& reader, std::size_t frame, Progress& progress) {
  const TakeIndex& index = reader.index();
  std::size_t chunk = index.frames[frame].chunk;
  if (index.chunks[chunk].header.kind == ChunkKind::change) {
    const auto content = reader.content(chunk);
    const auto sequence = content ? wholeFrameOf(*content) : std::nullopt;
    chunk = sequence ? chunkOfSequence(index, *sequence, ChunkKind::frame) : TakeIndex::kNoChunk;
  }
  const auto place = std::ranges::find(index.frames, chunk, &TakeIndex::Frame::chunk);
  // Then the next frame is whole.
  if (place == index.frames.end()) return Done{};
  const auto whole = reader.frame(static_cast<std::size_t>(place - index.frames.begin()));
  if (!whole) return whole.problem();
  progress.whole = {(*whole)->positions, (*whole)->velocities};
  progress.wholeSequence = index.chunks[chunk].header.sequence;
  progress.wholeNumber = index.chunks[chunk].header.frame;
  return Done{};
}

/// Where to go on after a frame, once all that is to be kept of it is seen to be intact.
Result<Progress> progressAfter(const FileTakeReader& reader, std::size_t frame) {
  const auto snapshot = reader.frame(frame);
  if (!snapshot) return snapshot.problem();
  if (const auto checkpoint = reader.checkpoint(frame); !checkpoint) return checkpoint.problem();
  const TakeIndex& index = reader.index();
  const TakeIndex::Frame& place = index.frames[frame];
  const ChunkHeader& frameHeader = index.chunks[place.chunk].header;
  Progress progress;
  progress.nextSequence = index.chunks[place.checkpoint].header.sequence + 1;
  progress.nextFrame = frameHeader.frame + 1;
  progress.lastTime = frameHeader.time;
  progress.brokenVersion = (*snapshot)->broken->version;
  progress.breakageSequence = frameHeader.base;
  if (const Status found = findWhole(reader, frame, progress); !found) return found.problem();
  return progress;
}

}  // namespace

Result<std::unique_ptr<TakeWriter>> TakeWriter::create(const std::filesystem::path& path,
                                                       const TakeHeader& header, const Network& network) {
  if (!std::isfinite(header.framesPerSecond) || !(header.framesPerSecond > 0.0))
    return Problem{path.string(), "the frames per second of a take must be a positive number", ""};
  if (const auto fault = network.validate())
    return Problem{path.string(), "the network is not sound: " + *fault, ""};
  auto file = TakeFile::create(path);
  if (!file) return file.problem();

  ByteWriter out;
  ChunkHeader chunk;
  appendChunk(out, chunk, encodeHead(header).bytes());
  chunk.kind = ChunkKind::network;
  chunk.sequence = 1;
  appendChunk(out, chunk, encodeNetwork(network).bytes());
  if (Status appended = file->append(out.bytes()); !appended) return appended.problem();
  Progress progress;
  progress.nextSequence = 2;
  return std::unique_ptr<TakeWriter>(
      new FileTakeWriter(std::move(file).value(), NetworkSize::of(network), std::move(progress)));
}

Result<std::unique_ptr<TakeWriter>> TakeWriter::continueAfter(const std::filesystem::path& path,
                                                              std::size_t lastFrame) {
  auto file = TakeFile::openToAppend(path);
  if (!file) return file.problem();
  auto reader = FileTakeReader::over(std::move(file).value());
  if (!reader) return reader.problem();
  auto progress = progressAfter(**reader, lastFrame);
  if (!progress) return progress.problem();
  const NetworkSize size = NetworkSize::of((*reader)->network());
  const TakeIndex& index = (*reader)->index();
  const std::uint64_t end = index.chunks[index.frames[lastFrame].checkpoint].end();
  const TakeIndex::Scenes scenes = index.scenesFrom(index.frames[lastFrame].scenes);
  const bool cutsScene =
      scenes.last > scenes.first && index.chunks[index.sceneChunks[scenes.last - 1]].offset >= end;
  const auto scene = cutsScene ? (*reader)->sceneOf(lastFrame) : Result<std::string>(std::string());
  if (!scene) return scene.problem();
  TakeFile kept = std::move(**reader).releaseFile();
  if (Status cut = kept.cut(end); !cut) return cut.problem();
  std::unique_ptr<TakeWriter> writer(new FileTakeWriter(std::move(kept), size, std::move(progress).value()));
  if (Status again = cutsScene ? writer->appendScene(*scene) : Status(Done{}); !again) return again.problem();
  return writer;
}

}  // namespace sim
