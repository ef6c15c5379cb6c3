#include <cstdio>
#include "accuracy/case.h"
using namespace tumble::accuracy;
int main(int argc, char** argv) {
  for (const Case& c : all_cases()) {
    if (argc > 1 && c.id != argv[1]) continue;
    for (const EngineKind& engine : engines())
      for (const Part& part : c.parts) {
        Trial trial(engine, engine.defaults, Effort::quick);
        Outcome o;
        try { o = part.run(trial); } catch (const Missing& m) { o.failed = "missing: " + m.what; }
        std::printf("%s %-8s %-20s error %.3e goal %.1e %s\n", c.id.c_str(), engine.name.c_str(), part.name.c_str(), o.error, part.goal, o.failed.c_str());
      }
  }
}
