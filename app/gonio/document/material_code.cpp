// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/material_code.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <chrono>
#include <cmath>

#include "core/dictionary/decode.h"
#include "core/formats/code.h"
#include "core/metrics/brdf_metrics.h"
#include "core/study/study_record.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

QString transformFormula(DataTransform transform) {
  if (transform == DataTransform::cosineLog) return QStringLiteral("ln(1 + ρ max(cos θi cos θo, 0.001))");
  if (const double offset = logOffset(transform); offset > 0)
    return offset == 1 ? QStringLiteral("ln(1 + ρ)") : QStringLiteral("ln(1 + ρ / %1)").arg(offset);
  const double gamma = gammaOf(transform);
  return gamma == 1 ? QStringLiteral("ρ") : gamma == 2 ? QStringLiteral("√ρ") : QStringLiteral("ρ^(1/%1)").arg(gamma);
}

namespace {

struct MaterialCodeText {
  Q_DECLARE_TR_FUNCTIONS(MaterialCode)
};
QString errorText(double value) { return QString::number(value, 'g', 3); }

/// Prepared once, in the background; matrices in single precision, a few MB.
struct Coder {
  std::shared_ptr<const materials::NamedEnsemble> dictionary = materials::bundledEnsemble();
  dictionary::Encoder encoder{dictionary->ensemble};
};

const Coder& coder() {
  static const Coder coder;
  return coder;
}

QString transformText(DataTransform transform) {
  return transform == DataTransform::cosineLog ? MaterialCodeText::tr("cosine-log") : MaterialCodeText::tr("log-plus");
}

/// "0.0021; cosine-log has 0.0034"
QString reason(const dictionary::EncodeResult& encoded) {
  QStringList chosen, others;
  for (const dictionary::EncodedCandidate& candidate : encoded.candidates)
    if (candidate.code.transform == encoded.code.transform)
      chosen << errorText(candidate.gammaError);
    else
      others << MaterialCodeText::tr("%1 has %2")
                    .arg(transformText(candidate.code.transform), errorText(candidate.gammaError));
  return (chosen + others).join(QStringLiteral("; "));
}

QString dictionaryText(const MaterialCode& code) {
  static constexpr std::array names{QT_TRANSLATE_NOOP("MaterialCode", "red"),
                                    QT_TRANSLATE_NOOP("MaterialCode", "green"),
                                    QT_TRANSLATE_NOOP("MaterialCode", "blue")};
  const auto& channels = code.encoded.code.channels;
  QStringList texts;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const int sparsity = code.dictionary->ensemble.dictionaries[std::size_t(channels[c].dictionary)].sparsity;
    texts << MaterialCodeText::tr("%1 no. %2 (learned with %3)")
                 .arg(MaterialCodeText::tr(names[c]))
                 .arg(channels[c].dictionary)
                 .arg(sparsity);
  }
  return texts.join(QStringLiteral("\n"));
}

}  // namespace

MaterialCode encodeMaterial(const LoadedMaterialPtr& material, std::size_t coefficients, const TaskControl& control) {
  using Clock = std::chrono::steady_clock;
  MaterialCode code;
  code.material = material;
  code.dictionary = coder().dictionary;
  code.coefficients = coefficients;
  dictionary::EncodeOptions options;
  options.coefficients = coefficients;
  options.quantised = true;
  const auto table = material->table(control);
  code.encoded = coder().encoder.encode(*table, options, control);
  control.throwIfStopped();
  const std::vector<std::byte> file = formats::encodeCode(code.encoded.code, code.dictionary->id);
  code.bytes = file.size();
  const std::shared_ptr<const dictionary::Ensemble> ensemble(code.dictionary, &code.dictionary->ensemble);
  code.stored = std::make_shared<const widgets::EnsembleCode>(
      widgets::EnsembleCode{ensemble, formats::readCode(io::MemorySource(file)).code});
  const auto start = Clock::now();
  code.table = dictionary::decode(*ensemble, code.stored->code);
  code.decodeSeconds = std::chrono::duration<double>(Clock::now() - start).count();
  code.warnings = dictionary::lostPeaks(*table, *code.table);
  control.throwIfStopped();
  code.density = std::make_shared<const TabulatedDensity>(*code.table);
  code.quality = study::measureQuality(*material->base, *dictionary::makeCodeBrdf(*ensemble, code.stored->code),
                                       code.table.get(), rendering::smallComparisonPicture(), control);
  return code;
}

std::vector<widgets::Fact> codeFacts(const MaterialCode& code) {
  const double tableBytes = double(code.material->bytes());
  const auto snrText = [](double snr) {
    return std::isfinite(snr) ? MaterialCodeText::tr("%1 dB").arg(snr, 0, 'f', 1) : QStringLiteral("∞");
  };
  std::vector<widgets::Fact> facts{
      {MaterialCodeText::tr("Error"),
       MaterialCodeText::tr("rendered SNR %1, BRDF SNR %2, log error %3")
           .arg(snrText(code.quality.renderedSnr), snrText(code.quality.brdfSnr),
                errorText(code.quality.errors[std::size_t(metrics::BrdfMetric::log)])),
       MaterialCodeText::tr("Error of the code against the measurement: signal-to-noise ratio of rendered spheres, and "
                            "of ρ cos θi cos θo over the cells;\nroot mean square difference of ln(1 + ρ cos θi) over "
                            "solid angle.")},
      {MaterialCodeText::tr("Size"),
       MaterialCodeText::tr("%1 kB; table: %2 MB")
           .arg(double(code.bytes) * 1e-3, 0, 'f', 1)
           .arg(tableBytes * 1e-6, 0, 'f', 1),
       MaterialCodeText::tr("Size of the code's file. The dictionary comes with "
                            "Gonio and is not counted.")},
      {MaterialCodeText::tr("Time"),
       MaterialCodeText::tr("%1, %2 to decode, %3 to encode")
           .arg(widgets::timesText(code.quality.cost), widgets::secondsText(code.decodeSeconds),
                widgets::secondsText(code.encoded.seconds)),
       MaterialCodeText::tr("Measured on this machine: one evaluation directly from the code on one core, a frame of "
                            "the path tracer\n(sphere, 128 × 128 pixels, 32 samples per pixel) on all cores, decoding "
                            "of all cells, and the encoding")},
      {MaterialCodeText::tr("Transform"),
       MaterialCodeText::tr("%1: y = %2")
           .arg(transformText(code.encoded.code.transform), transformFormula(code.encoded.code.transform)),
       MaterialCodeText::tr("Transform applied to the BRDF values before encoding. Log-plus and cosine-log were both "
                            "tried; the one with the smaller gamma error was chosen.")},
      {MaterialCodeText::tr("Gamma error"), reason(code.encoded),
       MaterialCodeText::tr("Mean of (√ρ − √ρ')² over the cells with polar angles up to 85°, weighted by projected "
                            "solid angle; ρ' is the decoded value.\nCloser to perception than the squared error of ρ, "
                            "which the highlight dominates. The transform with the smaller gamma error was chosen.")},
      {MaterialCodeText::tr("Dictionaries"), dictionaryText(code),
       MaterialCodeText::tr(
           "Dictionary of each channel: of %1 dictionaries, the one in which the largest coefficients of the material "
           "contain the most energy. All channels use the same dictionary unless separate ones lower the error by more "
           "than a quarter.\n\"Learned with\": number of coefficients per signal (one channel of a material) during "
           "training.")
           .arg(code.dictionary->ensemble.dictionaries.size())}};
  for (const std::string& warning : code.warnings)
    facts.push_back({MaterialCodeText::tr("Warning"), QString::fromStdString(warning),
                     MaterialCodeText::tr("More coefficients represent narrower and brighter peaks.")});
  return facts;
}

}  // namespace gonio::app
