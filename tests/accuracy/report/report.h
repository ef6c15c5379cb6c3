// The report: one static page with its plots, readable on a phone.
#pragma once

#include "accuracy/runner/row.h"

namespace tumble::accuracy {

// Writes index.html and SVG plots into the folder, which is made. Needs gnuplot.
void write_report(const std::string& folder, const std::vector<Row>& rows);

}  // namespace tumble::accuracy
