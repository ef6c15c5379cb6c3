#pragma once

#include "accuracy/report/plots.h"
#include "accuracy/runner/row.h"

namespace tumble::accuracy {

// The report as one HTML page that shows plots lying beside it.
std::string page(const std::vector<Row>& rows, const std::vector<Plot>& plots);

}  // namespace tumble::accuracy
