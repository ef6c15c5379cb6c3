#include "physics/dynamics/factor.h"

namespace tumble::dynamics {

void Factor::set_pattern(int size, const std::vector<std::pair<int, int>>& entries) {
  size_ = size;
  entries_ = entries;
  whole_.resize(entries.size());
  if (size <= kDense) dense_.setZero(size, size);
  else fronts_.analyze(size, entries);
}

void Factor::factor(const std::vector<double>& values, double regular) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto [row, column] = entries_[i];
    whole_[i] = row != column ? values[i] : values[i] > 0 ? values[i] * (1 + regular) : 1;
    if (size_ <= kDense) dense_(row, column) = dense_(column, row) = whole_[i];
  }
  if (size_ <= kDense) dense_factor_.compute(dense_);
  else fronts_.factor(whole_);
}

Eigen::VectorXd Factor::solve(const Eigen::VectorXd& right) const {
  if (size_ <= kDense) return dense_factor_.solve(right);
  return fronts_.solve(right);
}

}  // namespace tumble::dynamics
