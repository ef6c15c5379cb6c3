#include "accuracy/report/report.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "accuracy/report/page.h"
#include "accuracy/report/plots.h"
#include "base/error.h"

namespace fs = std::filesystem;

namespace tumble::accuracy {

void write_report(const std::string& folder, const std::vector<Row>& rows) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".svg") fs::remove(entry.path());
  std::vector<Plot> plots;
  for (const Case& c : all_cases()) {
    const bool ran = std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.id == c.id; });
    if (!ran) continue;
    if (const auto plot = cost_plot(c, rows)) plots.push_back(*plot);
    if (c.id[0] == 'A')
      if (const auto plot = order_plot(c, rows)) plots.push_back(*plot);
    const std::vector<Plot> traces = trace_plots(c);
    plots.insert(plots.end(), traces.begin(), traces.end());
  }
  draw(folder, plots);
  std::ofstream out(folder + "/index.html");
  out << page(rows, plots);
  if (!out.flush()) fail("measure: --report: '", folder, "/index.html' cannot be written");
}

}  // namespace tumble::accuracy
