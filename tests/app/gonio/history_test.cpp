// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/history.h"

#include <QTest>
#include <vector>

#include "tests/support/test_program.h"

namespace history_test {
using namespace gonio::app;

/// Sets a number and keeps a block of memory.
class SetNumber final : public Command {
 public:
  SetNumber(int& target, int value, std::size_t bytes) : m_target(target), m_after(value), m_bytes(bytes) {}
  std::size_t bytes() const override { return isForgotten() ? 0 : m_bytes; }

 protected:
  void apply() override {
    m_before = m_target;
    m_target = m_after;
  }
  void revert() override { m_target = m_before; }
  void release() override {}

 private:
  int& m_target;
  int m_before = 0, m_after;
  std::size_t m_bytes;
};
class HistoryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void boundedByBytes() {
    int number = 0;
    History history;
    history.setByteLimit(300);
    for (int i = 1; i <= 10; ++i) history.add(new SetNumber(number, i, 100));
    QCOMPARE(history.bytes(), std::size_t(300));
    QCOMPARE(number, 10);
    history.setIndex(7);
    QCOMPARE(number, 7);
    // Beyond the bound nothing is known: the state stays, in both directions.
    history.setIndex(0);
    QCOMPARE(number, 7);
    history.setIndex(10);
    QCOMPARE(number, 10);
  }

  void theNewestStepIsAlwaysKept() {
    int number = 0;
    History history;
    history.setByteLimit(10);
    history.add(new SetNumber(number, 1, 1000));
    history.undo();
    QCOMPARE(number, 0);
  }

  void aSavedStateBeyondTheBoundIsNoLongerClean() {
    int number = 0;
    History history;
    history.setByteLimit(200);
    history.add(new SetNumber(number, 1, 100));
    history.setClean();
    for (int i = 2; i <= 3; ++i) history.add(new SetNumber(number, i, 100));
    QCOMPARE(history.cleanIndex(), 1);  // the first step is forgotten, what follows the save is not
    history.add(new SetNumber(number, 4, 100));
    QCOMPARE(history.cleanIndex(), -1);
    history.setIndex(0);
    QVERIFY(!history.isClean());
  }
};

GONIO_TEST(HistoryTest)
}  // namespace history_test

#include "history_test.moc"
