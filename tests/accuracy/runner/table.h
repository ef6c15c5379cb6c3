#pragma once

#include "accuracy/runner/row.h"

namespace tumble::accuracy {

// Default settings, a line a part, our engine beside stock; then what sums them up.
void print_table(const std::vector<Row>& rows);

}  // namespace tumble::accuracy
