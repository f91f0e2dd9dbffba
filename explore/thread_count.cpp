#include "explore/thread_count.hpp"

#include <tbb/info.h>

namespace bodyline::explore {

int thread_count(int asked) { return asked > 0 ? asked : int(tbb::info::default_concurrency()); }

}  // namespace bodyline::explore
