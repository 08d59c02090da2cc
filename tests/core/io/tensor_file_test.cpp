// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/tensor_file.h"

#include <QTest>
#include <limits>

#include "core/io/byte_source.h"
#include "tests/core/io/synthetic_tensors.h"
#include "tests/support/test_program.h"

namespace tensor_file_test {
using namespace gonio;
using namespace gonio::test;

io::TensorFile parse(const Bytes& bytes) { return io::TensorFile(io::MemorySource(bytes)); }

/// The reader refuses, with a text of what it found and expected.
std::string mismatchOf(const Bytes& bytes) {
  try {
    parse(bytes);
  } catch (const io::FormatMismatch& mismatch) {
    return mismatch.what();
  }
  return {};
}

class TensorFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void fieldsAsWritten() {
    const io::TensorFile file =
        parse(tensorFile({byteField("description", "a paint"), floatField("ndf", {2, 3}, {1, 2, 3, 4, 5, 6}),
                          floatField("none", {0}, {})}));
    QCOMPARE(file.text("description"), std::string("a paint"));
    QCOMPARE(file.floats("ndf", 2), (std::vector<float>{1, 2, 3, 4, 5, 6}));
    QCOMPARE(file.field("ndf", io::TensorType::float32, 2).describe(), std::string("float32 2 x 3"));
    QVERIFY(file.floats("none", 1).empty());
    QVERIFY(file.contains("ndf") && !file.contains("rgb"));
  }

  void missingAndUnexpectedFieldsAreNamed() {
    const io::TensorFile file = parse(tensorFile({floatField("ndf", {2}, {1, 2}), byteField("text", "t")}));
    QVERIFY(contains(errorOf([&] { file.floats("rgb", 5); }), "ndf, text"));
    QVERIFY(contains(errorOf([&] { file.floats("ndf", 2); }), "'ndf' float32 2"));
    QVERIFY(contains(errorOf([&] { file.floats("text", 1); }), "'text' uint8 1"));
  }

  void hardCase42NotFiniteValuesAreNamedByIndex() {
    const float bad = std::numeric_limits<float>::infinity();
    const io::TensorFile file = parse(tensorFile({floatField("ndf", {3}, {1, 2, bad})}));
    QVERIFY(contains(errorOf([&] { file.floats("ndf", 1); }), "value 2 of 'ndf'"));
  }

  void hardCase13EveryCutIsRefused() {
    const Bytes whole = SyntheticRgl().file();
    for (std::size_t size = 0; size < whole.size(); ++size)
      QVERIFY(!mismatchOf(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).empty());
  }

  void hardCase13HostileDirectoriesAreRefused() {
    const std::uint64_t huge = std::uint64_t(1) << 40;
    TensorField field = floatField("a", {huge, huge}, {});
    QVERIFY(contains(mismatchOf(tensorFile({field})), "inside the file"));  // the product wraps to 0
    field.shape = {std::uint64_t(1) << 62};                                 // times 4 bytes wraps to 0
    QVERIFY(!mismatchOf(tensorFile({field})).empty());
    field.shape = {2};
    QVERIFY(!mismatchOf(tensorFile({field})).empty());
    field.shape = std::vector<std::uint64_t>(40, 1);
    field.type = io::TensorType(0);
    QVERIFY(!mismatchOf(tensorFile({field})).empty());
    field.type = io::TensorType(12);
    QVERIFY(!mismatchOf(tensorFile({field})).empty());
    QVERIFY(contains(mismatchOf(tensorFile({byteField("a", "1"), byteField("a", "2")})), "two fields 'a'"));

    Bytes bytes = tensorFile({byteField("a", "1")});
    Bytes other = bytes;
    other[12] = std::byte{2};
    QVERIFY(contains(mismatchOf(other), "version 2.0"));
    other = bytes;
    other[14] = other[15] = other[16] = other[17] = std::byte{0xff};  // four thousand million fields
    QVERIFY(!mismatchOf(other).empty());
    other = bytes;
    for (std::size_t i = 24; i < 32; ++i) other[i] = std::byte{0xff};  // an offset that wraps
    QVERIFY(!mismatchOf(other).empty());
  }
};

GONIO_TEST(TensorFileTest)
}  // namespace tensor_file_test

#include "tensor_file_test.moc"
