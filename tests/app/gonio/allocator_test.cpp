// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <memory>
#include <vector>

#include "tests/support/resident_memory.h"
#include "tests/support/test_program.h"

namespace allocator_test {
using namespace gonio;

/// The allocator of the editor, and the settings that it reads from the program.
class AllocatorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void readsItsSettings() {
    const auto control = test::jemallocControl();
    QVERIFY(control);
    unsigned arenas = 0;
    std::size_t size = sizeof arenas;
    QCOMPARE(control("opt.narenas", &arenas, &size, nullptr, 0), 0);
    QCOMPARE(arenas, 2u);
    bool inBackground = false;
    size = sizeof inBackground;
    QCOMPARE(control("background_thread", &inBackground, &size, nullptr, 0), 0);
    QVERIFY(inBackground);
  }

  /// Small blocks that stay keep no page of the large ones between which they were allocated.
  void returnsFreedMemory() {
    constexpr std::size_t count = 200'000, smallBytes = 48, largeBytes = 2'000;
    std::vector<std::unique_ptr<char[]>> small, large;
    const std::size_t before = test::residentMegabytes();
    for (std::size_t i = 0; i < count; ++i) {
      small.push_back(std::make_unique<char[]>(smallBytes));
      large.push_back(std::make_unique<char[]>(largeBytes));
    }
    QVERIFY(test::residentMegabytes() > before + count * largeBytes / 1'000'000);
    large.clear();
    large.shrink_to_fit();
    // Not at once if the thread in the background is returning memory, too.
    QTRY_VERIFY_WITH_TIMEOUT(test::residentMegabytes() < before + 3 * count * smallBytes / 1'000'000, 30'000);
  }
};

GONIO_TEST(AllocatorTest)
}  // namespace allocator_test

#include "allocator_test.moc"
