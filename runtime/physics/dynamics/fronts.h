// A sparse symmetric positive matrix, factored as L Lt by fronts: columns of L with the same rows are one dense block, and
// what a block takes from those after it is summed up in dense tables that its parent in the elimination tree collects
// (the multifrontal method: I. S. Duff, J. K. Reid, ACM Trans. Math. Softw. 9, 1983; J. W. H. Liu, SIAM Review 34, 1992).
// Rows of a joint come in threes and more, so that even a chain has such blocks; a net has large ones.
#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace tumble::dynamics {

class Fronts {
 public:
  // Entries that may differ from 0, row >= column, each once; all of the diagonal must be there.
  void analyze(int size, const std::vector<std::pair<int, int>>& entries);
  // In the order of the entries. A pivot of next to nothing is held above 0.
  void factor(const std::vector<double>& values);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Entry {
    int from, to;             // which of the values, and where in the front's table
  };
  struct Front {
    int first = 0, width = 0;   // its columns, in the order of elimination
    std::vector<int> rows;      // all rows, its own columns first
    std::vector<int> children;  // whose tables it collects; they were the last before it
    std::vector<int> places;    // of what its table leaves, in the parent's rows
    std::vector<Entry> entries;
    std::size_t block = 0;      // where its columns of L are kept, rows times width
    int rest() const { return static_cast<int>(rows.size()) - width; }
  };
  void join(const std::vector<std::vector<int>>& columns);
  void place(const std::vector<std::pair<int, int>>& entries);

  int size_ = 0;
  std::vector<int> order_;      // when each row is eliminated
  std::vector<Front> fronts_;   // children before parents
  std::vector<int> diagonal_;   // which of the entries it is
  std::vector<double> least_;   // that a pivot may be
  std::vector<double> blocks_, stack_;
  Eigen::MatrixXd table_;
};

}  // namespace tumble::dynamics
