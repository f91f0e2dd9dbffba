#pragma once

namespace bodyline::explore {

/// How many threads work where `asked` are asked for: all processors of this process when 0.
int thread_count(int asked);

}  // namespace bodyline::explore
