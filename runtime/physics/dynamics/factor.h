// The matrix of a mechanism, K = J M^-1 J^T, factored: what impulses along the rows J does it take to change the
// velocities along them?
#pragma once

#include <Eigen/Cholesky>

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
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  static constexpr int kDense = 12;  // up to here a full matrix is quicker
  int size_ = 0;
  std::vector<std::pair<int, int>> entries_;
  std::vector<double> whole_;  // values, and what is added
  Eigen::MatrixXd dense_;
  Eigen::LDLT<Eigen::MatrixXd> dense_factor_;
  Fronts fronts_;
};

}  // namespace tumble::dynamics
