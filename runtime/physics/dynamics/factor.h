// The matrix of a mechanism, K = J M^-1 J^T, factored: what impulses along the rows J does it take to change the
// velocities along them?
#pragma once

#include "physics/dynamics/fronts.h"

namespace tumble::dynamics {

class Factor {
 public:
  // Entries that may differ from 0, row >= column, each once; all of the diagonal must be there. Kept until set anew.
  void set_pattern(int size, const std::vector<std::pair<int, int>>& entries);
  int size() const { return size_; }
  // In the pattern's order. Rows that say the same twice are told apart by a part of the diagonal that is added to it: then
  // one of the solutions is found, and all of them move the bodies alike.
  void factor(const std::vector<double>& values, double regular);
  Eigen::VectorXd solve(Eigen::VectorXd right) const;
  void solve_in_place(Eigen::VectorXd& x) const;

 private:
  static constexpr int kDense = 12;  // up to here a full matrix is quicker
  double& dense(int row, int column) { return dense_[static_cast<std::size_t>(row * size_ + column)]; }
  double dense(int row, int column) const { return dense_[static_cast<std::size_t>(row * size_ + column)]; }
  void factor_dense();
  void solve_dense(Eigen::VectorXd& x) const;

  int size_ = 0;
  std::vector<std::pair<int, int>> entries_;
  std::vector<double> whole_;  // values, and what is added
  std::vector<double> dense_;  // by rows; L below the diagonal of L D L^T, and 1 / D on it
  Fronts fronts_;
};

}  // namespace tumble::dynamics
