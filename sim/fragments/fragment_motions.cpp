#include "sim/fragments/fragment_motions.h"

namespace sim {

std::size_t FragmentMotions::memoryBytes() const {
  std::size_t bytes = activity.memoryBytes() + records.capacity() * sizeof(FragmentRecord) +
                      (neighbours.capacity() + neighboursBefore.capacity()) * sizeof(FragmentNeighbours);
  for (const RigidBody& body : bodies) bytes += body.memoryBytes();
  return bytes;
}

}  // namespace sim
