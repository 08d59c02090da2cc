// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/blend_source.h"
#include "core/brdf/rgl_brdf.h"

#include <QTemporaryDir>
#include <QTest>

#include "core/dictionary/code_interpolation.h"
#include "core/models/registry.h"
#include "tests/support/code_files.h"
#include "tests/support/table_file.h"
#include "tests/support/test_program.h"

namespace blend_source_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::documents;
using namespace gonio::editing;

std::shared_ptr<const TabulatedBrdf> lambert(double albedo) {
  static const HalfDifferenceGrid grid;
  return std::make_shared<const TabulatedBrdf>(
      grid, std::vector<TabulatedBrdf::Value>(grid.size(), glm::vec3(float(albedo / pi))),
      std::vector<std::uint8_t>(grid.size(), 1));
}

std::string textOf(const std::exception& error) { return error.what(); }

/// Documents about blends: two grey MERL files in a folder.
class BlendSourceTest : public QObject {
  Q_OBJECT
 private:
  QTemporaryDir m_folder;

  std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }
  EditDocument fileDocument(const char* name) const {
    EditDocument document;
    document.sourcePath = path(name);
    document.sourceSha256 = materials::readMaterial(document.sourcePath).source.sha256;
    return document;
  }
  EditDocument blendDocument(std::vector<double> weights = {0.25, 0.75},
                             InterpolationSpace space = InterpolationSpace::linear) const {
    auto blend = std::make_shared<BlendSource>();
    blend->space = space;
    blend->model = &models::ggx();
    blend->weights = std::move(weights);
    blend->materials = {fileDocument("dark.binary"), fileDocument("light.binary")};
    EditDocument document;
    document.blend = blend;
    document.sourceSha256 = blendSha256(*blend);
    return document;
  }
  std::string errorOf(const nlohmann::json& json) const {
    try {
      documentFromJson(json);
    } catch (const Error& error) {
      return textOf(error);
    }
    return {};
  }

 private Q_SLOTS:
  void initTestCase() {
    test::writeTable(*lambert(0.2), path("dark.binary"));
    test::writeTable(*lambert(0.6), path("light.binary"));
  }

  /// Read again, a blend is the sum that its weights say, and its hash is the one that was written.
  void aBlendIsMadeAgain() {
    const EditDocument document = blendDocument();
    writeDocument(document, path("blend.gonio"));
    const EditDocument stored = readDocument(path("blend.gonio"));
    const materials::Material material = readSource(stored, path("blend.gonio"));
    const double value = material.brdf->evaluate({0, 0, 1}, {0, 0, 1}).r;
    QVERIFY(std::abs(value - (0.25 * 0.2 + 0.75 * 0.6) / pi) < 1e-6);
    QCOMPARE(material.source.sha256, document.sourceSha256);
    QCOMPARE(material.source.sha256, stored.sourceSha256);
    QCOMPARE(material.name, std::string("dark + light"));
    QCOMPARE(material.source.description, std::string("25 % dark, 75 % light; space linear"));
    QVERIFY(material.source.path.empty());
  }

  /// The materials' paths go with the folder, as a document's own does; resolved, they need none.
  void pathsAreRelative() {
    writeDocument(blendDocument(), path("blend.gonio"));
    const EditDocument stored = readDocument(path("blend.gonio"));
    QCOMPARE(stored.blend->materials[1].sourcePath, std::string("light.binary"));
    const EditDocument absolute = resolved(stored, path("blend.gonio"));
    QCOMPARE(absolute.blend->materials[1].sourcePath, path("light.binary"));
    readSource(absolute, "/elsewhere/blend.gonio");
    QVERIFY_THROWS_EXCEPTION(Error, readSource(stored, "/elsewhere/blend.gonio"));
  }

  /// A material's own edits count, and blends of blends are blends.
  void materialsHaveEditsAndMayBeBlends() {
    EditDocument document = blendDocument();
    DifferentialEdit edit{.model = &models::findModel("lambert")};
    edit.fitted.values = {Rgb(0.2)};
    edit.edited.values = {Rgb(0.5)};
    auto outer = std::make_shared<BlendSource>();
    outer->weights = {0.5, 0.5};
    outer->materials = {blendDocument(), fileDocument("dark.binary")};
    outer->materials[1].edits = {{edit}};
    document.blend = outer;
    document.sourceSha256 = blendSha256(*outer);
    const EditDocument again = documentFromJson(toJson(document));
    const materials::Material material = readSource(again, {});
    const double value = material.brdf->evaluate({0, 0, 1}, {0, 0, 1}).r;
    QVERIFY(std::abs(value - (0.5 * 0.5 + 0.5 * 0.5) / pi) < 1e-6);
    QCOMPARE(material.source.sha256, document.sourceSha256);
  }

  /// RGL files blend to an RGL file, where its nodes are stated; beside a table the material is the sum itself.
  void filesOfOneFormKeepIt() {
    EditDocument document;
    auto blend = std::make_shared<BlendSource>();
    blend->weights = {0.25, 0.75};
    blend->materials.resize(2);
    blend->materials[0].sourcePath = "library:rgl/paper_blue";
    blend->materials[1].sourcePath = "library:rgl/paper_white";
    document.blend = blend;
    const materials::Material own = readSource(document, {});
    QVERIFY(formOf<RglBrdf>(*own.brdf) && !own.table);
    QCOMPARE(own.source.notes.size(), std::size_t(1));
    QVERIFY(own.source.notes[0].find("angles of paper_") != std::string::npos);

    blend->materials[1] = fileDocument("light.binary");
    const materials::Material mixed = readSource(document, {});
    QVERIFY(!mixed.table && !formOf<TabulatedBrdf>(*mixed.brdf) && !formOf<RglBrdf>(*mixed.brdf));
    const auto paper = materials::readMaterial(blend->materials[0].sourcePath).brdf;
    const Direction wi = fromSpherical(0.4, 1), wo = fromSpherical(0.8, 2);
    const Rgb expected = 0.25 * paper->evaluate(wi, wo) + Rgb(0.75 * 0.6 / pi);
    QVERIFY(glm::length(mixed.brdf->evaluate(wi, wo) - expected) < 1e-6);
  }

  void theHashTellsBlendsApart() {
    const auto hash = [](const EditDocument& document) { return blendSha256(*document.blend); };
    QVERIFY(hash(blendDocument({0.25, 0.75})) == hash(blendDocument({0.25, 0.75})));
    QVERIFY(hash(blendDocument({0.25, 0.75})) != hash(blendDocument({0.75, 0.25})));
    QVERIFY(hash(blendDocument()) != hash(blendDocument({0.25, 0.75}, InterpolationSpace::parameters)));
    EditDocument moved = blendDocument();
    auto blend = std::make_shared<BlendSource>(*moved.blend);
    blend->materials[0].sourcePath = "/another/place.binary";
    QVERIFY(blendSha256(*blend) == hash(moved));
    blend->materials[0].sourceSha256 = std::string(64, '0');
    QVERIFY(blendSha256(*blend) != hash(moved));
  }

  void theModelIsKept() {
    const EditDocument again = documentFromJson(toJson(blendDocument({0.25, 0.75}, InterpolationSpace::differential)));
    QCOMPARE(again.blend->model, &models::ggx());
    QCOMPARE(again.blend->space, InterpolationSpace::differential);
    QVERIFY(!documentFromJson(toJson(blendDocument())).blend->model);
  }

  /// The switch is written where it acts and on. A document without it, as those of 0.2.0 are, has it off, and the hash
  /// that it had.
  void theSwitchOfTheDetailIsKept() {
    for (const std::string_view name : interpolationSpaceNames) {
      const auto space =
          InterpolationSpace(std::find(interpolationSpaceNames.begin(), interpolationSpaceNames.end(), name) -
                             interpolationSpaceNames.begin());
      nlohmann::json on = toJson(blendDocument({0.25, 0.75}, space));
      QCOMPARE(on["source"]["blend"].contains("keepDetail"), losesDetail(space));
      QCOMPARE(documentFromJson(on).blend->preserveDetail, losesDetail(space));
      QCOMPARE(blendSha256(*documentFromJson(on).blend), blendSha256(*blendDocument({0.25, 0.75}, space).blend));
      on["source"]["blend"].erase("keepDetail");
      const EditDocument old = documentFromJson(on);
      QVERIFY(!old.blend->preserveDetail);
      QVERIFY(!toJson(old)["source"]["blend"].contains("keepDetail"));
      QCOMPARE(blendSha256(*old.blend) == blendSha256(*blendDocument({0.25, 0.75}, space).blend), !losesDetail(space));
    }
    nlohmann::json wrong = toJson(blendDocument({0.25, 0.75}, InterpolationSpace::factors));
    wrong["source"]["blend"]["keepDetail"] = "yes";
    QVERIFY(errorOf(wrong).find("source.blend.keepDetail") != std::string::npos);
  }

  /// A document of 0.2.0, as that wrote it: the model alone, in a table, under the same hash.
  void documentsOfEarlierVersions() {
    nlohmann::json json = toJson(blendDocument({0.25, 0.75}, InterpolationSpace::parameters));
    json["version"] = 6;
    json["source"]["blend"].erase("keepDetail");
    json["source"]["blend"]["model"] = "phong";
    const materials::Material material = readSource(documentFromJson(json), {});
    QVERIFY(material.table);
    std::vector<InterpolationMaterial> ends{{.table = lambert(0.2)}, {.table = lambert(0.6)}};
    const auto between = prepareInterpolation(InterpolationSpace::parameters, ends,
                                              {.preserveDetail = false, .model = &models::findModel("phong")});
    const auto table = between->table(std::vector{0.25, 0.75});
    QVERIFY(std::ranges::equal(table->values(), material.table->values()));
  }

  /// In a space that loses detail RGL files give the RGL file of the blend with their detail; without, a table.
  void filesOfOneFormKeepItWithTheirDetail() {
    EditDocument document;
    auto blend = std::make_shared<BlendSource>();
    blend->space = InterpolationSpace::parameters;
    blend->model = &models::findModel("lambert");
    blend->weights = {0.25, 0.75};
    blend->materials.resize(2);
    blend->materials[0].sourcePath = "library:rgl/paper_blue";
    blend->materials[1].sourcePath = "library:rgl/paper_white";
    document.blend = blend;
    const materials::Material own = readSource(document, {});
    QVERIFY(formOf<RglBrdf>(*own.brdf) && !own.table && !own.brdf->isReciprocal());
    blend->materials[1] = fileDocument("light.binary");
    const materials::Material mixed = readSource(document, {});
    QVERIFY(!mixed.table && !mixed.brdf->isReciprocal());
    blend->preserveDetail = false;
    QVERIFY(readSource(document, {}).table);
  }

  void errorsNameThePlace() {
    nlohmann::json json = toJson(blendDocument());
    const auto with = [&](const char* pointer, const nlohmann::json& value) {
      nlohmann::json changed = json;
      changed[nlohmann::json::json_pointer(pointer)] = value;
      return errorOf(changed);
    };
    QCOMPARE(errorOf(json), std::string());
    QVERIFY(with("/source/blend/space", "sideways").find("source.blend.space") != std::string::npos);
    QVERIFY(with("/source/blend/materials/1/weight", 0.5).find("add up") != std::string::npos);
    QVERIFY(with("/source/blend/materials/1/weight", -1).find("materials[1].weight") != std::string::npos);
    QVERIFY(with("/source/blend/materials", nlohmann::json::array()).find("source.blend.materials") !=
            std::string::npos);
    QVERIFY(with("/source/blend/materials/0/source", 7).find("materials[0].source") != std::string::npos);
    QVERIFY(with("/source/blend", 7).find("source.blend") != std::string::npos);
  }

  /// A file of ten thousand braces must not end the program.
  void blendsInBlendsAreBounded() {
    const auto nested = [&](int blends) {
      nlohmann::json json = toJson(blendDocument());
      const nlohmann::json source = json["source"];
      for (int i = 1; i < blends; ++i) {
        nlohmann::json outer = source;
        outer["blend"]["materials"][0]["source"] = json["source"];
        json["source"] = outer;
      }
      return errorOf(json);
    };
    QCOMPARE(nested(6), std::string());
    QVERIFY(nested(maxBlendsInBlends).find("sampled") != std::string::npos);
    QVERIFY(nested(maxBlendsInBlends + 1).find("more than 16 nested blends") != std::string::npos);
  }

  /// Each material takes time wherever the document is shown, also in a thumbnail.
  void blendsOfTooManyMaterialsAreRefused() {
    const auto blendOf = [this](std::size_t count) {
      BlendSource blend = *blendDocument().blend;
      blend.materials.assign(count, blend.materials.front());
      blend.weights.assign(count, 1.0 / double(count));
      EditDocument document = blendDocument();
      document.blend = std::make_shared<const BlendSource>(blend);
      return document;
    };
    const auto refused = [this](const EditDocument& document, int samplings) {
      return errorOf(toJson(document))
          .starts_with("source.blend: found a blend whose materials are sampled " + std::to_string(samplings) +
                       " times, expected at most 32");
    };
    QCOMPARE(errorOf(toJson(blendOf(maxBlendSamplings))), std::string());
    QVERIFY(refused(blendOf(maxBlendSamplings + 1), 33));
    // Those of a blend inside a blend count twice: 4 x 4 x 2, and 2 more.
    EditDocument outer = blendOf(4);
    BlendSource blend = *outer.blend;
    blend.materials.assign(4, blendOf(4));
    outer.blend = std::make_shared<const BlendSource>(blend);
    QCOMPARE(errorOf(toJson(outer)), std::string());
    blend.materials.back() = blendOf(5);
    outer.blend = std::make_shared<const BlendSource>(blend);
    QVERIFY(refused(outer, 34));
  }

  /// A blend of codes names its ensemble, unless that is the one of version 0.2.0, whose documents name none.
  void theDictionaryOfABlendIsStored() {
    for (const std::uint64_t id : materials::bundledIds()) {
      EditDocument document = blendDocument({0.25, 0.75}, InterpolationSpace::dictionary);
      auto blend = std::make_shared<BlendSource>(*document.blend);
      blend->dictionary = id;
      document.blend = blend;
      nlohmann::json json = toJson(document);
      QCOMPARE(json["source"]["blend"].contains("dictionary"), id != materials::bundledIds().back());
      QCOMPARE(documentFromJson(json).blend->dictionary, id);
      json["source"]["blend"]["dictionary"] = "0123456789abcdef";
      QVERIFY(QString::fromStdString(errorOf(json)).contains("source.blend.dictionary"));
    }
    QCOMPARE(blendOptions(nullptr, true, materials::bundledIds().back()).ensemble.get(),
             &materials::bundledEnsemble(materials::bundledIds().back())->ensemble);
  }

  /// Files that are codes: until they are edited the space of dictionaries blends those, and encodes nothing.
  void codesAreBlendedAsTheyAre() {
    std::vector<InterpolationMaterial> ends;
    std::vector<dictionary::SparseCode> codes;
    for (const char* name : {"vch_golden_yellow", "chm_light_blue"}) {
      const materials::Material material = materials::readMaterial(test::codeFile(name));
      const auto table = material.tabulated();
      QCOMPARE(interpolationMaterial(material, table, table, lambert(0.5), {}).code, nullptr);
      ends.push_back(interpolationMaterial(material, table, table, table, {}));
      QVERIFY(ends.back().code);
      codes.push_back(*ends.back().code);
    }
    QCOMPARE(codes[0].transform, codes[1].transform);
    const std::vector<double> weights{0.25, 0.75};
    const InterpolationOptions options = blendOptions();
    const auto blend = prepareInterpolation(InterpolationSpace::dictionary, ends, options)->code(weights);
    const dictionary::SparseCode expected =
        dictionary::interpolateCodes(*ends.front().ensemble, codes, weights, options.codeCoefficients);
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(blend->channels[c].dictionary, expected.channels[c].dictionary);
      QCOMPARE(blend->channels[c].coefficients.size(), expected.channels[c].coefficients.size());
      for (std::size_t i = 0; i < expected.channels[c].coefficients.size(); ++i) {
        QCOMPARE(blend->channels[c].coefficients[i].index, expected.channels[c].coefficients[i].index);
        QCOMPARE(blend->channels[c].coefficients[i].value, expected.channels[c].coefficients[i].value);
      }
    }
  }

  /// A file that is gone is named.
  void missingFilesAreNamed() {
    EditDocument document = blendDocument();
    auto blend = std::make_shared<BlendSource>(*document.blend);
    blend->materials[0].sourcePath = path("gone.binary");
    document.blend = blend;
    try {
      readSource(document, {});
      QFAIL("read");
    } catch (const Error& error) {
      QVERIFY(textOf(error).find("gone.binary") != std::string::npos);
    }
  }
};

GONIO_TEST(BlendSourceTest)
}  // namespace blend_source_test

#include "blend_source_test.moc"
