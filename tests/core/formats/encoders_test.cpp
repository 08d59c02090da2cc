// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/encode.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "core/brdf/utia_brdf.h"
#include "core/coordinates/half_difference.h"
#include "core/formats/formats.h"
#include "core/formats/rgl.h"
#include "core/io/atomic_file.h"
#include "core/io/tensor_file.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "tests/core/export/published_reader.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

/// The tests run over the rows of the table of formats: a format that is written is tested without a new line.
namespace encoders_test {
using namespace gonio;
using materials::EditedMaterial;
using materials::Encoded;
using materials::MaterialFormat;

constexpr materials::EncodeOptions small{.snr = 30, .pictureSize = 32, .samples = 16};

std::vector<const MaterialFormat*> written() {
  std::vector<const MaterialFormat*> formats;
  for (const MaterialFormat* format : materials::materialFormats())
    if (format->encode) formats.push_back(format);
  return formats;
}

/// Reciprocal and smooth, so that every format holds it well.
EditedMaterial glossy() { return materials::unedited("glossy", test::ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.5), 0.5, 0.04)); }

/// Neither reciprocal nor isotropic, with colours outside sRGB.
Rgb grained(const Direction& wi, const Direction& wo) {
  return {0.2 + 0.1 * wi.x * wi.x, 0.3 + 0.2 * wo.z, 0.1 * wi.z - 0.05};
}
EditedMaterial difficult() {
  return materials::unedited("grained", std::make_shared<test::FunctionBrdf>(grained, false, false));
}

test::Bytes utiaBytes() {
  return test::utiaFile(
      test::utiaValues([](const Direction& wi, const Direction& wo) { return glm::max(Rgb(0), grained(wi, wo)); }));
}
materials::Material utia() {
  materials::Material material = materials::readMaterial(io::MemorySource(utiaBytes()));
  material.source.path = "cloth.exr";
  return material;
}

/// An edit of the colours alone, which keeps no value.
editing::EditList tinted() {
  const models::Model& lambert = models::findModel("lambert");
  editing::DifferentialEdit change{&lambert, models::defaultParameters(lambert.spec()),
                                   models::defaultParameters(lambert.spec())};
  change.controls.values[std::size_t(editing::ArtistControl::tint)] = Rgb(0.5, 1, 2);
  return {editing::Edit{change}};
}

/// A position in the cell of a node of an axis, of `count` steps; that of phi_d wraps.
double inCell(int node, int count, bool wraps, double part) {
  const double low = wraps ? node - 0.5 : std::max(0.0, node - 0.5),
               high = !wraps && node + 1 == count ? count : node + 0.5;
  return (low + (high - low) * part) / count;
}

/// A pair of directions in a cell; empty if one is below the horizon. @param parts of the cell along its three axes.
std::optional<DirectionPair> pairInCell(const HalfDifferenceGrid& grid, std::size_t cell, const glm::dvec3& parts,
                                        double turn) {
  const int k = int(cell) % grid.phiDCount, j = int(cell) / grid.phiDCount % grid.thetaDCount,
            i = int(cell) / grid.phiDCount / grid.thetaDCount;
  const double h = inCell(i, grid.thetaHCount, false, parts.x);
  DirectionPair pair = fromHalfDifference(h * h * halfPi, inCell(j, grid.thetaDCount, false, parts.y) * halfPi,
                                          inCell(k, grid.phiDCount, true, parts.z) * grid.phiDPeriod());
  if (!(pair.wi.z > 0 && pair.wo.z > 0)) return std::nullopt;
  const double c = std::cos(turn), s = std::sin(turn);
  for (Direction* w : {&pair.wi, &pair.wo}) *w = {c * w->x - s * w->y, s * w->x + c * w->y, w->z};
  return pair;
}

/// The energies of the values and of their differences, both with both cosines.
glm::dvec2 energiesAt(const Brdf& material, const Brdf& file, const DirectionPair& pair) {
  const Rgb truth = material.evaluate(pair.wi, pair.wo) * (pair.wi.z * pair.wo.z);
  const Rgb difference = file.evaluate(pair.wi, pair.wo) * (pair.wi.z * pair.wo.z) - truth;
  return {glm::dot(truth, truth), glm::dot(difference, difference)};
}

/// That of a file that is a table, else that of MERL files, 180 steps of phi_d; of both orders of the directions where
/// one of the two is not reciprocal.
HalfDifferenceGrid comparedGrid(const Brdf& material, const Brdf& file) {
  const auto* table = formOf<TabulatedBrdf>(file);
  HalfDifferenceGrid grid = table ? table->grid() : HalfDifferenceGrid();
  if (!grid.reciprocal || (material.isReciprocal() && file.isReciprocal())) return grid;
  grid.reciprocal = false;
  if (table) grid.phiDCount *= 2;
  return grid;
}

/// BRDF SNR of a file over the stated pair of each cell of the MERL grid, by a loop of its own.
double brdfSnrOf(const Brdf& material, const Brdf& file) {
  const HalfDifferenceGrid grid = comparedGrid(material, file);
  const bool isotropic = material.isIsotropic() && file.isIsotropic();
  const auto step = [](std::size_t n, int power) {
    const double position = double(n) / std::pow(1.2207440846057595, power);
    return (std::floor(16 * (position - std::floor(position))) + 0.5) / 16;
  };
  glm::dvec2 energies(0);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const std::size_t count = std::size_t(grid.phiDCount), k = cell % count;
    const std::size_t n = 2 * k > count ? cell - k + count - k : cell;
    const double phi = step(n, 3);
    const auto pair = pairInCell(grid, cell, {step(n, 1), step(n, 2), n == cell ? phi : 1 - phi},
                                 isotropic ? 0 : 2 * pi * double(cell) * (std::sqrt(5.0) - 1) / 2);
    if (pair) energies += energiesAt(material, file, *pair);
  }
  return 10 * std::log10(energies.x / energies.y);
}

/// BRDF SNR over 100,000 pairs of directions drawn with the same weights, and its standard error, dB.
glm::dvec2 drawnSnr(const Brdf& material, const Brdf& file) {
  const HalfDifferenceGrid grid = comparedGrid(material, file);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0, 1);
  glm::dvec2 mean(0);
  std::vector<glm::dvec2> drawn;
  while (drawn.size() < 100000)
    if (const auto pair = pairInCell(grid, random() % grid.size(), {uniform(random), uniform(random), uniform(random)},
                                     2 * pi * uniform(random))) {
      drawn.push_back(energiesAt(material, file, *pair));
      mean += drawn.back() / 100000.0;
    }
  // Of the logarithm of a ratio of two means, by the delta method.
  double variance = 0;
  for (const glm::dvec2& at : drawn) {
    const double deviation = at.x / mean.x - at.y / mean.y;
    variance += deviation * deviation / (100000.0 * 100000.0);
  }
  return {10 * std::log10(mean.x / mean.y), 10 / std::log(10) * std::sqrt(variance)};
}

/// encode() of glossy() or difficult(), once.
const Encoded& encodedOnce(const EditedMaterial& material, const MaterialFormat& format) {
  static std::map<std::pair<std::string, const MaterialFormat*>, Encoded> known;
  const auto [entry, isNew] = known.try_emplace({material.shown.name, &format});
  if (isNew) entry->second = materials::encode(material, format, small);
  return entry->second;
}

class EncodersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A reader of the bytes gets what encode() says that it gets; written again, nothing is lost any more.
  void readersGetWhatIsStated() {
    for (const MaterialFormat* format : written()) {
      const Encoded& made = encodedOnce(glossy(), *format);
      const materials::Material again = materials::readMaterial(io::MemorySource(made.bytes));
      QCOMPARE(again.source.format, std::string(format->name));
      std::mt19937_64 random(3);
      for (int i = 0; i < 2000; ++i) {
        const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
        const Rgb found = again.brdf->evaluate(pair.wi, pair.wo), stated = made.readBack->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c)
          QVERIFY2(std::abs(found[c] - stated[c]) <= 1e-5 * std::abs(stated[c]) + 1e-9, format->label.data());
      }
      QVERIFY2(made.snr > 20 && made.brdfSnr > 20 && !made.losses.empty(), format->label.data());
      const Encoded copy = materials::encode(materials::unedited(again), *format, small);
      QVERIFY2(std::isinf(copy.snr) && std::isinf(copy.brdfSnr) && copy.losses.empty(), format->label.data());
      QVERIFY2(copy.bytes == made.bytes || format == &formats::rglFormat, format->label.data());
    }
  }

  /// The stated BRDF SNR is that of a loop over the stated cells, and of directions drawn at random.
  void theStatedAccuracyIsThatOfTheFile() {
    for (const MaterialFormat* format : written())
      for (const EditedMaterial& material : {glossy(), difficult()}) {
        const Encoded& made = encodedOnce(material, *format);
        const double expected = brdfSnrOf(*material.shown.brdf, *made.readBack);
        QVERIFY2(std::abs(made.brdfSnr - expected) < 0.01,
                 qPrintable(QString("%1: %2, expected %3").arg(format->label.data()).arg(made.brdfSnr).arg(expected)));
        const glm::dvec2 drawn = drawnSnr(*material.shown.brdf, *made.readBack);
        qInfo("%s, %s: %.2f dB, drawn %.2f +- %.2f dB", format->label.data(), material.shown.name.c_str(), made.brdfSnr,
              drawn.x, drawn.y);
        QVERIFY2(std::abs(made.brdfSnr - drawn.x) < 3 * drawn.y, format->label.data());
      }
  }

  /// A file of each format, read and written without edits, stays as it is, byte for byte.
  void uneditedFilesAreCopied() {
    const QTemporaryDir folder;
    for (const MaterialFormat* format : written()) {
      const auto path = (folder.filePath("file").toStdString()).append(format->suffix());
      const std::vector<std::byte>& bytes = encodedOnce(glossy(), *format).bytes;
      io::writeFileAtomically(path, bytes);
      const EditedMaterial material = materials::unedited(materials::readMaterial(path));
      const Encoded copy = materials::encode(material, *format, small);
      QVERIFY2(copy.bytes == bytes, format->label.data());
      QVERIFY2(copy.losses.empty() && std::isinf(copy.snr) && std::isinf(copy.brdfSnr), format->label.data());
      // Only what has been read is copied.
      io::writeFileAtomically(path, std::vector<std::byte>(bytes.begin(), bytes.end() - 1));
      QVERIFY(test::errorOf([&] { materials::encode(material, *format, small); }).find("has changed") !=
              std::string::npos);
    }
  }

  /// A bundled file lacks fields that other readers need: they are added, wherever the file lies.
  void bundledFilesAreCompleted() {
    const QTemporaryDir folder;
    const materials::Material bundled = materials::readMaterial("library:rgl/paper_blue");
    const auto path = folder.filePath("paper.bsdf").toStdString();
    io::writeFileAtomically(path, materials::materialFile(bundled.source));
    for (const materials::Material& material : {bundled, materials::readMaterial(path)}) {
      const Encoded made = materials::encode(materials::unedited(material), formats::rglFormat, small);
      const io::TensorFile file{io::MemorySource(made.bytes)};
      for (const char* field : {"vndf", "luminance", "rgb"}) QVERIFY2(file.contains(field), field);
      QVERIFY(made.losses.empty() && std::isinf(made.snr));
    }
  }

  /// What a row cannot hold is a loss of every file of such a material.
  void whatAFormatCannotHoldIsALoss() {
    for (const MaterialFormat* format : written()) {
      const std::vector<std::string> losses = encodedOnce(difficult(), *format).losses;
      const auto states = [&](const char* word) {
        return std::ranges::any_of(losses, [&](const std::string& loss) { return loss.find(word) != loss.npos; });
      };
      QCOMPARE(states("anisotropic"), !format->holds.anisotropic);
      QCOMPARE(states("not reciprocal"), !format->holds.nonReciprocal);
      QCOMPARE(states("negative"), format != &formats::rglFormat);
    }
  }

  /// A table of the whole circle keeps what is not reciprocal; a folded one does not.
  void theWholeCircleKeepsBothOrders() {
    const EditedMaterial paper = materials::unedited(materials::readMaterial("library:rgl/paper_blue"));
    const Encoded circle = materials::encode(paper, formats::merlCircleFormat);
    QCOMPARE(circle.losses.size(), std::size_t(1));
    QVERIFY(circle.snr > 40);
    const Encoded folded = materials::encode(paper, formats::merlFormat);
    QCOMPARE(folded.losses.size(), std::size_t(2));
    QVERIFY(folded.snr < circle.snr && folded.brdfSnr < circle.brdfSnr);
  }

  /// A file that is displayed with the light as its incident direction is not copied: readers take the viewer.
  void theDisplayedIncidentDirectionIsWritten() {
    for (const MaterialFormat* format : {&formats::utiaFormat, &formats::rglFormat}) {
      const QTemporaryDir folder;
      materials::Material base = materials::readMaterial("library:rgl/paper_blue");
      if (format == &formats::utiaFormat) {
        const auto path = folder.filePath("cloth.bin").toStdString();
        io::writeFileAtomically(path, utiaBytes());
        base = materials::readMaterial(path);
      }
      const auto viewer = base.brdf;
      base.brdf = withIncident(base.brdf, IncidentDirection::light);
      const Encoded made = materials::encode(materials::unedited(base), *format, small);
      const auto read = materials::readMaterial(io::MemorySource(made.bytes)).brdf;
      const double found = metrics::brdfSignalToNoiseRatio(*base.brdf, *read),
                   asStored = metrics::brdfSignalToNoiseRatio(*base.brdf, *viewer);
      QVERIFY2(found > asStored + 0.5,
               qPrintable(QString("%1: %2, %3 dB").arg(format->label.data()).arg(found).arg(asStored)));
      QVERIFY(std::abs(made.brdfSnr - found) < 0.01);
    }
  }

  void formatsThatAreOnlyReadAreRefused() {
    for (const MaterialFormat* format : materials::materialFormats()) {
      if (format->encode) continue;
      const std::string error = test::errorOf([&] { materials::encode(glossy(), *format, small); });
      QVERIFY2(error.find("only read") != error.npos, error.c_str());
    }
    for (const char* name : {"a.BINARY", "a.Bsdf", "a.bin"}) materials::checkWritableSuffix(name);
    for (const char* name : {"a.exr", "a.txt", "a"}) {
      const std::string error = test::errorOf([&] { materials::writeMaterial(glossy(), name, small); });
      QVERIFY2(error.starts_with(std::string(name) + ": found the suffix"), error.c_str());
    }
  }

  void theFormatThatKeepsMostComesFirst() {
    const auto first = [](const Brdf& brdf) { return materials::writableFormats(brdf).front(); };
    QVERIFY(first(*utia().brdf) == &formats::utiaFormat);
    QVERIFY(first(*materials::readMaterial("library:rgl/paper_blue").brdf) == &formats::rglFormat);
    const auto table = bakeTable(*glossy().shown.brdf);
    QVERIFY(first(*table) == &formats::merlFormat);
    const HalfDifferenceGrid circle{.thetaHCount = 6, .thetaDCount = 6, .phiDCount = 24, .reciprocal = false};
    const auto whole = bakeTable(*glossy().shown.brdf, circle);
    QVERIFY(first(*whole) == &formats::merlCircleFormat);
    QVERIFY(&materials::writableFormat("a.binary", *whole) == &formats::merlCircleFormat);
    QVERIFY(&materials::writableFormat("a.binary", *table) == &formats::merlFormat);
    QVERIFY(&materials::writableFormat("a.binary", *table, {.grid = circle}) == &formats::merlCircleFormat);
  }

  /// Each node of a UTIA file has its own value or the edited one, exactly: the values are not interpolated.
  void nodesOfUtiaFilesStay() {
    const materials::Material base = utia();
    const auto& values = *formOf<UtiaBrdf>(*base.brdf)->values();
    const auto valuesOf = [](const EditedMaterial& material) {
      const Encoded made = materials::encode(material, formats::utiaFormat, small);
      return *formOf<UtiaBrdf>(*materials::readMaterial(io::MemorySource(made.bytes)).brdf)->values();
    };
    EditedMaterial edited = materials::unedited(base);
    QVERIFY(valuesOf(edited) == values);
    edited.shown.brdf = std::make_shared<test::FunctionBrdf>(
        [&base](const Direction& wi, const Direction& wo) {
          return base.brdf->evaluate(wi, wo) * (wo.y < 0 ? 0.5 : 1.0);
        },
        false, false);
    const auto after = valuesOf(edited);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Direction viewer = test::utiaDirection(i / UtiaBrdf::directionCount);
      const float factor = viewer.y < 0 ? 0.5f : 1;
      for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(after[i][c] - factor * values[i][c]) < (factor == 1 ? 1e-30f : 1e-6f));
    }
  }

  /// Edits of the colours keep the nodes of an RGL file; a table is edited cell by cell.
  void editsKeepTheForm() {
    EditedMaterial paper = materials::unedited(materials::readMaterial("library:rgl/paper_blue"));
    paper.edits = tinted();
    paper.shown = materials::withEdits(paper.base, paper.edits);
    const Encoded made = materials::encode(paper, formats::rglFormat, small);
    QVERIFY2(made.losses.empty() && made.snr > 45, qPrintable(QString::number(made.snr)));
    const RglData& before = formOf<RglBrdf>(*paper.base.brdf)->tables()->data;
    const auto again = materials::readMaterial(io::MemorySource(made.bytes));
    const RglData& after = formOf<RglBrdf>(*again.brdf)->tables()->data;
    QVERIFY(after.incident.thetas() == before.incident.thetas() && after.ndf.values == before.ndf.values);

    const HalfDifferenceGrid grid{.thetaHCount = 12, .thetaDCount = 12, .phiDCount = 24};
    EditedMaterial table = materials::unedited("table", bakeTable(*glossy().shown.brdf, grid));
    table.edits = tinted();
    table.shown = materials::withEdits(table.base, table.edits);
    const Encoded cells = materials::encode(table, formats::merlFormat, small);
    QVERIFY(cells.losses.empty() && std::isinf(cells.snr));
    const auto read = materials::readMaterial(io::MemorySource(cells.bytes));
    QVERIFY(std::ranges::equal(read.table->values(), table.shown.table->values()));
  }

  /// A measured file with narrower and wider highlights, read by the published formula alone: the light that it
  /// reflects is that of the edited material, at directions that the file itself draws.
  void editedRglFilesAreReadAsTheMaterial() {
    const models::Model& ggx = models::findModel("ggx");
    for (const double roughness : {0.25, 0.5, 4.0}) {
      editing::DifferentialEdit change{&ggx, models::defaultParameters(ggx.spec()),
                                       models::defaultParameters(ggx.spec()), editing::defaultComposition(ggx)};
      for (models::ParameterValues* values : {&change.fitted, &change.edited})
        values->values[*ggx.spec().find("roughness")] = Rgb(0.12);
      change.controls.values[std::size_t(editing::ArtistControl::roughness)] = Rgb(roughness);
      EditedMaterial material = materials::unedited(materials::readMaterial("library:rgl/satin_purple"));
      material.edits = {editing::Edit{change}};
      material.shown = materials::withEdits(material.base, material.edits);
      const rgl::EncodedRgl made = formats::encodeRgl(material);
      QVERIFY2(made.rgbSnr >= 40 && made.spectralSnr >= 40, qPrintable(QString::number(made.rgbSnr)));
      const test::PublishedReader file(made.rgb);
      std::mt19937_64 random(9);
      std::uniform_real_distribution<double> uniform(0, 1);
      double energy = 0, error = 0, readError = 0;
      for (int i = 0; i < 100000; ++i) {
        // Viewers up to 75 degrees, as often as they see a part of a sphere's picture.
        const Direction viewer = fromSpherical(std::asin(std::sqrt(0.93 * uniform(random))), 2 * pi * uniform(random));
        const DirectionSample drawn = made.rgbBrdf->sample(viewer, {uniform(random), uniform(random), uniform(random)});
        if (!(drawn.pdf > 0)) continue;
        const Rgb truth = material.shown.brdf->evaluate(drawn.wi, viewer) * drawn.wi.z;
        const Rgb read = file.value(viewer, drawn.wi) * drawn.wi.z, difference = read - truth;
        const Rgb other = glm::max(Rgb(0), made.rgbBrdf->evaluate(drawn.wi, viewer)) * drawn.wi.z - read;
        readError += glm::dot(other, other) / drawn.pdf;
        energy += glm::dot(truth, truth) / drawn.pdf;
        error += glm::dot(difference, difference) / drawn.pdf;
      }
      // Single values are blurred by no picture.
      const double found = 10 * std::log10(energy / error), same = 10 * std::log10(energy / readError);
      QVERIFY2(found > 25 && same > 60, qPrintable(QString("x %1: %2, %3 dB").arg(roughness).arg(found).arg(same)));
    }
  }

  void aMissedSnrSaysWhatWouldHelp() {
    const Encoded exact{}, poor{.snr = 12.34};
    const MaterialFormat &merl = formats::merlFormat, &rgl = formats::rglFormat;
    QCOMPARE(materials::shortfall(exact, merl, {}), std::string());
    const std::string text = materials::shortfall(poor, merl, {});
    QVERIFY2(text.find("12.3 dB") != text.npos && text.find(".bsdf") != text.npos, text.c_str());
    QVERIFY(materials::shortfall(poor, rgl, {}).find(".bsdf") == std::string::npos);
  }
};

GONIO_TEST(EncodersTest)

}  // namespace encoders_test

#include "encoders_test.moc"
