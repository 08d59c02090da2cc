// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/atomic_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <vector>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace scratch_file_test {
using namespace gonio;

class ScratchFileTest : public QObject {
  Q_OBJECT

  const QTemporaryDir m_folder;

 private Q_SLOTS:
  void whatIsWrittenIsRead() {
    io::ScratchFile file(m_folder.path().toStdString(), 4000);
    std::vector<float> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i);
    file.write(2000, std::span(values).last(500));
    file.write(0, std::span(values).first(500));
    std::vector<float> back(10);
    file.read(4 * 495, back);
    QCOMPARE(back, std::vector<float>(values.begin() + 495, values.begin() + 505));
    QVERIFY_THROWS_EXCEPTION(Error, file.read(4 * 995, back));
    QVERIFY(QDir(m_folder.path()).isEmpty());  // nothing is left behind, whatever happens
  }

  void foldersThatCannotHoldIt() {
    QVERIFY_THROWS_EXCEPTION(Error, io::ScratchFile("/no/such/folder", 1));
    try {
      io::ScratchFile(m_folder.path().toStdString(), std::uint64_t(1) << 62);
      QFAIL("it took more than any disk has");
    } catch (const Error& error) {
      QVERIFY(QString(error.what()).contains(m_folder.path()));
    }
  }
};

GONIO_TEST(ScratchFileTest)
}  // namespace scratch_file_test

#include "scratch_file_test.moc"
