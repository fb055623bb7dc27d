#include "ui/session/footage.h"

#include <algorithm>
#include <atomic>

#include "modeling/exchange/take_scene.h"

namespace ui {
namespace {

/// Bytes of frames held by all footages.
std::atomic<std::size_t> heldBytes{0};

std::size_t bytesOf(const sim::Network& network) {
  return network.nodeCount() * (2 * sizeof(sim::Vec3) + sizeof(sim::FragmentId)) + network.bondCount() +
         network.cellCount();
}

std::uint32_t countPieces(const sim::Broken& broken) {
  return static_cast<std::uint32_t>(
      std::count_if(broken.fragments.begin(), broken.fragments.end(),
                    [](const sim::Fragment& fragment) { return fragment.nodeCount > 1; }));
}

}  // namespace

Footage::Footage(std::shared_ptr<const sim::Network> network, modeling::Scene scene,
                 std::filesystem::path file)
    : file_(std::move(file)),
      network_(std::move(network)),
      scene_(std::make_shared<const modeling::Scene>(std::move(scene))),
      frameBytes_(bytesOf(*network_)) {}

Footage::~Footage() {
  for (const Entry& entry : entries_) {
    if (entry.held) heldBytes -= frameBytes_;
  }
}

sim::Result<std::shared_ptr<Footage>> Footage::open(const std::filesystem::path& file) {
  auto opened = sim::TakeReader::open(file);
  if (!opened) return opened.problem();
  const std::shared_ptr<const sim::TakeReader> reader = std::move(opened).value();
  sim::Result<modeling::Scene> scene = modeling::sceneOf(*reader);
  if (!scene) return scene.problem();
  // The reader's own network, without a copy.
  const std::shared_ptr<const sim::Network> network(reader, &reader->network());
  auto footage = std::make_shared<Footage>(network, std::move(scene).value(), file);
  footage->reader_ = reader;
  footage->fromFile_ = true;
  footage->entries_.resize(reader->frameCount());
  for (std::size_t frame = 0; frame < reader->frameCount(); ++frame)
    footage->entries_[frame].note.time = reader->frameTime(frame);
  return footage;
}

std::shared_ptr<const sim::Network> Footage::network() {
  {
    const std::lock_guard lock(mutex_);
    if (network_) return network_;
  }
  const auto from = reader(0);
  if (!from) return nullptr;
  const std::lock_guard lock(mutex_);
  // The reader's own, without a copy.
  if (!network_) network_ = std::shared_ptr<const sim::Network>(*from, &(*from)->network());
  return network_;
}

void Footage::letGo() {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return;
  {
    const std::lock_guard lock(readerMutex_);
    reader_.reset();
  }
  const std::lock_guard lock(mutex_);
  network_.reset();
  for (Entry& entry : entries_) {
    if (!entry.held) continue;
    entry.held.reset();
    heldBytes -= frameBytes_;
  }
  nextHeld_ = 0;
  events_ = {};
  fromFile_ = true;
}

std::shared_ptr<const modeling::Scene> Footage::scene() const {
  const std::lock_guard lock(mutex_);
  return scene_;
}

void Footage::setScene(std::shared_ptr<const modeling::Scene> scene) {
  const std::lock_guard lock(mutex_);
  scene_ = std::move(scene);
}

std::size_t Footage::frameCount() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

double Footage::duration() const {
  const std::lock_guard lock(mutex_);
  return entries_.empty() ? 0.0 : entries_.back().note.time;
}

FrameNote Footage::note(std::size_t frame) const {
  const std::lock_guard lock(mutex_);
  return frame < entries_.size() ? entries_[frame].note : FrameNote{};
}

std::vector<FrameNote> Footage::notes(std::size_t from) const {
  const std::lock_guard lock(mutex_);
  std::vector<FrameNote> notes;
  for (std::size_t frame = from; frame < entries_.size(); ++frame) notes.push_back(entries_[frame].note);
  return notes;
}

std::size_t Footage::notedCount() const {
  const std::lock_guard lock(mutex_);
  return notedCount_;
}

std::size_t Footage::frameAt(double time) const {
  const std::lock_guard lock(mutex_);
  const auto after =
      std::upper_bound(entries_.begin(), entries_.end(), time,
                       [](double moment, const Entry& entry) { return moment < entry.note.time; });
  return after == entries_.begin() ? 0 : static_cast<std::size_t>(after - entries_.begin()) - 1;
}

std::optional<double> Footage::firstBreak() const {
  const std::lock_guard lock(mutex_);
  if (firstBreak_) return firstBreak_;
  for (const Entry& entry : entries_) {
    if (entry.note.breaks > 0) return entry.note.time;
  }
  return std::nullopt;
}

sim::SnapshotPointer Footage::held(std::size_t frame) const {
  const std::lock_guard lock(mutex_);
  return frame < entries_.size() ? entries_[frame].held : nullptr;
}

sim::Result<std::shared_ptr<const sim::TakeReader>> Footage::reader(std::size_t frame) {
  const std::lock_guard lock(readerMutex_);
  if (!reader_ || reader_->frameCount() <= frame) {
    auto opened = sim::TakeReader::open(file_);
    if (!opened) return opened.problem();
    reader_ = std::move(opened).value();
  }
  if (reader_->frameCount() <= frame)
    return sim::Problem{file_.string(), "frame " + std::to_string(frame) + " is not in the file any more",
                        "simulate again"};
  return reader_;
}

sim::Result<sim::SnapshotPointer> Footage::frame(std::size_t frame) {
  if (sim::SnapshotPointer moment = held(frame)) return moment;
  const auto from = reader(frame);
  if (!from) return from.problem();
  return (*from)->frame(frame);
}

sim::Result<std::vector<sim::BreakEvent>> Footage::events() {
  {
    const std::lock_guard lock(mutex_);
    if (!fromFile_) return events_;
  }
  const auto from = reader(0);
  if (!from) return from.problem();
  return (*from)->events();
}

void Footage::append(sim::SnapshotPointer frame, const FrameNote& note, std::vector<sim::BreakEvent> events) {
  const std::lock_guard lock(mutex_);
  Entry& entry = entries_.emplace_back();
  entry.note = note;
  entry.note.time = frame->time;
  entry.note.ledger = frame->ledger;
  entry.note.fragments = countPieces(*frame->broken);
  entry.note.breaks = static_cast<std::uint32_t>(events.size());
  entry.note.brokenBonds = static_cast<std::uint32_t>(frame->broken->lostBonds());
  entry.noted = true;
  ++notedCount_;
  entry.held = std::move(frame);
  heldBytes += frameBytes_;
  if (!firstBreak_ && !events.empty()) firstBreak_ = events.front().time;
  events_.insert(events_.end(), events.begin(), events.end());
  makeRoom();
}

/// The first frame stays: everything starts from it.
void Footage::makeRoom() {
  while (heldBytes > kMemoryBudget && nextHeld_ + 2 < entries_.size()) {
    Entry& oldest = entries_[++nextHeld_];
    if (!oldest.held) continue;
    oldest.held.reset();
    heldBytes -= frameBytes_;
  }
}

bool Footage::readNextNote() {
  std::size_t index = 0;
  {
    const std::lock_guard lock(mutex_);
    while (notesRead_ < entries_.size() && entries_[notesRead_].noted) ++notesRead_;
    if (notesRead_ == entries_.size()) return false;
    index = notesRead_++;
  }
  const auto from = reader(index);
  if (!from) return true;
  const auto events = (*from)->eventsOf(index);
  const auto moment = (*from)->frame(index);
  if (!moment) return true;
  FrameNote note;
  note.time = (*moment)->time;
  note.ledger = (*moment)->ledger;
  note.fragments = countPieces(*(*moment)->broken);
  note.brokenBonds = static_cast<std::uint32_t>((*moment)->broken->lostBonds());
  if (events) note.breaks = static_cast<std::uint32_t>(events->size());
  const std::lock_guard lock(mutex_);
  entries_[index].note = note;
  entries_[index].noted = true;
  ++notedCount_;
  return true;
}

}  // namespace ui
