#include "base/error.h"

namespace tumble {

// Out of line, so that hosts and libtumble share one type_info and a host can catch what we throw.
Error::~Error() = default;

}  // namespace tumble
