#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a25_casts();
Case a26_triggers();
Case b18_tiles();
Case b19_walker();

std::vector<Case> query_cases() { return {a25_casts(), a26_triggers(), b18_tiles(), b19_walker()}; }

}  // namespace tumble::accuracy
