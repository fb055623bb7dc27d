#include "sim/contact/fragment_boxes.h"

#include <algorithm>

namespace sim {

FragmentBoxes::FragmentBoxes(const NodeVectors& positions, std::span<const FragmentId> fragmentOfNode,
                             std::size_t fragmentCount)
    : boxes_(fragmentCount) {
  for (std::size_t node = 0; node < positions.size(); ++node)
    boxes_[fragmentOfNode[node]].extend(positions.get(node));
}

std::vector<FragmentBoxes::Box> FragmentBoxes::meetings(double distance) const {
  std::vector<Box> meetings(boxes_.size());
  Box all;
  std::vector<FragmentId> order;
  for (FragmentId fragment = 0; fragment < boxes_.size(); ++fragment) {
    if (boxes_[fragment].isEmpty()) continue;
    all.extend(boxes_[fragment]);
    order.push_back(fragment);
  }
  if (order.size() < 2) return meetings;
  Eigen::Index axis = 0;
  all.sizes().maxCoeff(&axis);
  std::sort(order.begin(), order.end(), [&](FragmentId left, FragmentId right) {
    return std::pair(boxes_[left].min()[axis], left) < std::pair(boxes_[right].min()[axis], right);
  });
  const auto widened = [&](const Box& box) {
    return Box((box.min().array() - distance).matrix(), (box.max().array() + distance).matrix());
  };
  for (std::size_t first = 0; first < order.size(); ++first) {
    const Box& one = boxes_[order[first]];
    const Box near = widened(one);
    for (std::size_t second = first + 1; second < order.size(); ++second) {
      const Box& other = boxes_[order[second]];
      if (other.min()[axis] > near.max()[axis]) break;
      if (!near.intersects(other)) continue;
      meetings[order[first]].extend(one.intersection(widened(other)));
      meetings[order[second]].extend(other.intersection(near));
    }
  }
  return meetings;
}

}  // namespace sim
