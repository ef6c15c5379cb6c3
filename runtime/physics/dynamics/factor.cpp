#include "physics/dynamics/factor.h"

namespace tumble::dynamics {

void Factor::set_pattern(int size, const std::vector<std::pair<int, int>>& entries) {
  size_ = size;
  entries_ = entries;
  sparse_factor_.reset();
  if (size <= kDense) {
    dense_.setZero(size, size);
    return;
  }
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto& [row, column] : entries) triplets.emplace_back(row, column, 1.0);
  sparse_.resize(size, size);
  sparse_.setFromTriplets(triplets.begin(), triplets.end());
  places_.clear();
  for (const auto& [row, column] : entries) places_.push_back(static_cast<int>(&sparse_.coeffRef(row, column) - sparse_.valuePtr()));
  sparse_factor_ = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>();
  sparse_factor_->analyzePattern(sparse_);
}

void Factor::factor(const std::vector<double>& values, double regular) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto [row, column] = entries_[i];
    const double value = row != column ? values[i] : values[i] > 0 ? values[i] * (1 + regular) : 1;
    if (sparse_factor_) sparse_.valuePtr()[places_[i]] = value;
    else dense_(row, column) = dense_(column, row) = value;
  }
  if (sparse_factor_) sparse_factor_->factorize(sparse_);
  else dense_factor_.compute(dense_);
}

Eigen::VectorXd Factor::solve(const Eigen::VectorXd& right) const {
  if (sparse_factor_) return sparse_factor_->solve(right);
  return dense_factor_.solve(right);
}

}  // namespace tumble::dynamics
