#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/polygon_range.hpp"
#include "spanline/model/transform.hpp"

namespace spanline {

/// An instance of a list that an order is about.
struct OrderedInstance {
  const Mesh* mesh = nullptr;  ///< validated; it stays until the frame is drawn
  Transform transform{};
  Material material{};
};

/// What is submitted next: an instance, or some of its polygons.
struct Submission {
  std::uint32_t instance = 0;  ///< number in the list of instances that the order belongs to
  bool whole = true;           ///< all polygons of the instance; otherwise those of `polygons`
  PolygonRange polygons{};
};

/// An order in which instances, or polygons, are handed over to a renderer, whoever made it: a list, the walk of a
/// tree, boxes sorted by what hides what. `next(submission)` gives the next one, or returns false behind the last.
/// Submissions of one instance that follow one another share its vertices on the screen; an instance that comes again
/// behind another is put there again.
template <class Order>
concept SubmissionOrder = requires(Order order, Submission& submission) {
  { order.next(submission) } -> std::same_as<bool>;
};

/// The order of a list.
class ListedOrder {
 public:
  explicit ListedOrder(std::span<const Submission> list) : list_(list) {}
  [[nodiscard]] bool next(Submission& submission) {
    if (next_ == list_.size()) return false;
    submission = list_[next_++];
    return true;
  }

 private:
  std::span<const Submission> list_;
  std::size_t next_ = 0;
};

}  // namespace spanline
