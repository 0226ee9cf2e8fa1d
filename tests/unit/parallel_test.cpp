// SPDX-License-Identifier: MIT
#include "orthoball/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace orthoball {
namespace {

TEST(Parallel, EveryTaskIsCalledOnce) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    for (const std::size_t tasks : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> calls(tasks);
      parallel_for(Threads(threads), tasks, [&](std::size_t task) { ++calls[task]; });
      for (const auto& count : calls) EXPECT_EQ(count, 1);
    }
  }
}

TEST(Parallel, OneThreadKeepsTheOrderAndIsTheCallers) {
  std::vector<std::size_t> order;
  const auto caller = std::this_thread::get_id();
  parallel_for(Threads(1), 100, [&](std::size_t task) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(task);
  });
  ASSERT_EQ(order.size(), 100U);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(Parallel, WhatATaskThrowsIsThrown) {
  for (const unsigned threads : {1U, 3U}) {
    const auto body = [](std::size_t task) {
      if (task == 17) throw std::runtime_error("17");
    };
    EXPECT_THROW(parallel_for(Threads(threads), 100, body), std::runtime_error);
  }
}

TEST(Parallel, PartsFollowEachOtherAndDifferByOneAtMost) {
  for (const std::size_t size : {0U, 1U, 7U, 100U}) {
    for (const std::size_t parts : {1U, 2U, 3U, 16U}) {
      std::size_t expected = 0;
      parallel_parts(Threads(1), size, parts, [&](std::size_t, std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin, expected);
        EXPECT_GE(end - begin, size / parts);
        EXPECT_LE(end - begin, size / parts + 1);
        expected = end;
      });
      EXPECT_EQ(expected, size);
    }
  }
}

TEST(Threads, SmallWorksStayOnOne) {
  EXPECT_EQ(Threads(8).for_work(999, 1000).count(), 1U);
  EXPECT_EQ(Threads(8).for_work(3000, 1000).count(), 3U);
  EXPECT_EQ(Threads(8).for_work(1'000'000, 1000).count(), 8U);
  EXPECT_EQ(Threads(0).count(), 1U);
  EXPECT_GE(Threads().count(), 1U);
}

}  // namespace
}  // namespace orthoball
