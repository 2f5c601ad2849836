#pragma once
// An operator new of the whole program that can be told to fail once, and counts what is alive.

#include <cstddef>
#include <functional>

namespace windloom::testing {

/// Lets the next `count` wishes for memory of at least `leastBytes`, of all threads together, be fulfilled and the one
/// after them fail, once. Smaller ones never fail: as where the system has little left, and not nothing.
void failAfter(long count, std::size_t leastBytes);
/// No wish fails any more. True where one has since failAfter().
bool stopFailing();
/// Wishes since failAfter().
long wishes();
/// What is alive of all threads.
long alive();

/// Runs `work` with each of its wishes failing in turn, every `stride`-th where there are many. Each time what it took
/// must be free again when it ended, and `after` is called, to look whether all is as before. `work` must not throw
/// anything but std::bad_alloc, and must end well where nothing fails. The number of runs with a failure.
long failEach(const std::function<void()>& work, const std::function<void()>& after, long stride = 1,
              std::size_t leastBytes = 0);

}  // namespace windloom::testing
