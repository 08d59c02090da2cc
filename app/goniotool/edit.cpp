// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/documents/edit_document.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

struct EditArguments {
  std::string material, model, out;
  std::vector<std::string> set, controls;
  double strength = 1;
  std::string composition;
  bool changesAlbedo = false;
};

bool writesDocument(const EditArguments& options) { return documents::isDocumentName(options.out); }

/// One or three finite numbers, separated by commas.
Rgb parseValue(const std::string& text, const std::string& assignment) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, ','))
    if (const auto value = finiteNumber(part)) numbers.push_back(*value);
  const auto parts = std::size_t(1 + std::ranges::count(text, ','));
  if (numbers.size() != parts || (parts != 1 && parts != 3))
    throw UsageError("edit: found '" + assignment +
                     "', expected name=value or name=red,green,blue with finite numbers");
  return parts == 1 ? Rgb(numbers[0]) : Rgb(numbers[0], numbers[1], numbers[2]);
}

/// Without the model, which decides on the rest.
void checkAssignment(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError("found '" + assignment + "', expected name=value or name=red,green,blue");
  for (const std::string& part : CLI::detail::split(assignment.substr(equals + 1), ','))
    if (double value = 0; CLI::detail::lexical_cast(part, value) && !std::isfinite(value))
      throw UsageError("found '" + assignment + "', expected finite numbers");
}

/// "diffuse, specular, roughness".
std::string namesOf(const models::ModelSpec& spec) {
  std::string names;
  for (const models::ParameterSpec& parameter : spec.parameters)
    names += (names.empty() ? "" : ", ") + std::string(parameter.id);
  return names;
}

/// `values` with one assignment "name=value" made; a choice may be given by its name.
void assign(const models::ModelSpec& spec, const std::string& assignment, models::ParameterValues& values) {
  const auto equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  const auto index = spec.find(name);
  if (!index || equals == std::string::npos) {
    throw UsageError("edit: found '" + assignment + "', expected name=value with a parameter of " +
                     std::string(spec.id) + ": " + namesOf(spec));
  }
  const models::ParameterSpec& parameter = spec.parameters[*index];
  const std::string text = assignment.substr(equals + 1);
  for (std::size_t choice = 0; choice < parameter.choices.size(); ++choice)
    if (parameter.choices[choice] == text) {
      values.values[*index] = Rgb(double(choice));
      return;
    }
  const Rgb value = parseValue(text, assignment);
  if (!parameter.perChannel && value != Rgb(value.x))
    throw UsageError("edit: found '" + assignment + "', expected one number, which is for all channels");
  values.values[*index] = value;
}

void checkRange(const models::ModelSpec& spec, const models::ParameterValues& values) {
  try {
    models::checkHardRange(spec, values);
  } catch (const Error& error) {
    throw UsageError(std::string("edit: ") + error.what());
  }
}

documents::EditDocument documentOf(const materials::Material& material, const editing::Edit& edit) {
  documents::EditDocument document;
  document.sourcePath = material.source.path.string();
  document.sourceSha256 = material.source.sha256;
  document.edits = {edit};
  return document;
}

int replayDocument(const EditArguments& options, const Tool& tool) {
  if (!options.model.empty() || !options.set.empty() || !options.controls.empty())
    throw UsageError("edit: " + options.material +
                     " is a document, which contains its own edits: leave out --model, --set and --control");
  const materials::EditedMaterial material =
      documents::openWithEdits(options.material, tool.control("applying the edits"));
  const WrittenMaterial written = writeMaterial(material, options.out, tool);
  Json json{{"edits", material.edits.size()},
            {"averagedAzimuths", averagedAzimuths(*material.shown.brdf, options.out)},
            {"out", options.out}};
  json.update(written.json());
  const study::UseCost cost = study::measureUse(*material.shown.brdf, tool.control("measuring"));
  addCost(json, cost);
  print(tool, json,
        options.out + ": " + std::to_string(material.edits.size()) + " edits, " + costText(cost) + "\n" + written.text);
  return 0;
}

/// What happened to the values of an edited material on their way to a file; nothing for a document.
struct EditedFile {
  study::UseCost cost;  ///< of the edited material itself
  std::size_t capped = 0;
  int averaged = 0;
  WrittenMaterial written;
};

void printEdit(const editing::Edit& edit, const fitting::FitResult& fitted, const EditedFile& file,
               const EditArguments& options, const Tool& tool) {
  const auto& change = std::get<editing::DifferentialEdit>(edit.content);
  const models::ModelSpec& spec = change.model->spec();
  const models::ParameterValues after = change.target();
  std::string text =
      options.out + ": " + std::string(spec.name) + ", " + costText(file.cost) + "\n" + parametersText(spec, after);
  Json json{{"model", spec.id},
            {"fitted", parametersJson(spec, change.fitted)},
            {"edited", parametersJson(spec, after)},
            {"errors", errorsJson(fitted.errors)},
            {"strength", edit.strength},
            {"composition", editing::compositionIds[std::size_t(change.composition)]},
            {"keepAlbedo", change.keepsAlbedo},
            {"controls", parametersJson(editing::artistControls(), change.controls)}};
  json["cappedValues"] = file.capped;
  json["averagedAzimuths"] = file.averaged;
  if (file.written.bytes > 0) json.update(file.written.json());
  addCost(json, file.cost);
  json["seconds"] = fitted.seconds;
  json["out"] = options.out;
  print(tool, json, text + file.written.text);
}

editing::Composition compositionOf(const EditArguments& options, const models::Model& model) {
  if (options.composition.empty()) return editing::defaultComposition(model);
  const auto found = std::ranges::find(editing::compositionIds, options.composition);
  const auto composition = editing::Composition(found - editing::compositionIds.begin());
  if (composition == editing::Composition::lobes && !model.hasLobes())
    throw UsageError("edit: --compose lobes needs a model that is a sum of lobes (" + models::modelsWithLobes() +
                     "), found " + std::string(model.spec().id));
  return composition;
}

/// @throws UsageError where there is no such control or the model has nothing that it changes.
void probeControl(const std::string& assignment, const models::Model& model) {
  models::ParameterValues values = models::defaultParameters(editing::artistControls());
  assign(editing::artistControls(), assignment, values);
  checkRange(editing::artistControls(), values);
  const std::string name = assignment.substr(0, assignment.find('='));
  if (!editing::actsOn(editing::ArtistControl(*editing::artistControls().find(name)), model.spec()))
    throw UsageError("edit: " + std::string(model.spec().id) + " has no parameter that --control " + name + " changes");
}

int edit(const EditArguments& options, const Tool& tool) {
  const bool fromDocument = documents::isDocument(options.material);
  if (fromDocument) {
    materials::checkWritableSuffix(options.out);
    return replayDocument(options, tool);
  }
  if (!writesDocument(options)) materials::checkWritableSuffix(options.out, documents::documentSuffix);
  if (options.model.empty()) throw UsageError("edit: --model is missing; it names the model to fit and edit");
  const models::Model& model = models::findModel(options.model);
  // Wrong assignments are reported before the work starts.
  models::ParameterValues probe = models::defaultParameters(model.spec());
  for (const std::string& assignment : options.set) assign(model.spec(), assignment, probe);
  checkRange(model.spec(), probe);
  for (const std::string& assignment : options.controls) probeControl(assignment, model);
  compositionOf(options, model);

  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  const auto base = fitting::fitBase(material.brdf, material.tabulated(tool.control("tabulating")));
  const fitting::FitResult fitted = fitting::fit(base, model, {}, tool.control("fitting"));
  tool.throwIfStopped();
  editing::DifferentialEdit change = editing::unchangedEdit(model, fitted.parameters);
  change.composition = compositionOf(options, model);
  change.keepsAlbedo = !options.changesAlbedo;
  for (const std::string& assignment : options.set) assign(model.spec(), assignment, change.edited);
  for (const std::string& assignment : options.controls) assign(editing::artistControls(), assignment, change.controls);
  const editing::Edit edit{change, "", options.strength};
  EditedFile file;
  materials::EditedMaterial edited = materials::unedited(material);
  edited.edits = {edit};
  edited.shown = materials::withEdits(material, edited.edits, tool.control("editing"), &file.capped);
  file.cost = study::measureUse(*edited.shown.brdf, tool.control("measuring"));
  if (writesDocument(options)) {
    file.capped = 0;
    documents::writeDocument(documentOf(material, edit), options.out);
  } else {
    file.averaged = averagedAzimuths(*edited.shown.brdf, options.out);
    file.written = writeMaterial(edited, options.out, tool);
  }
  printEdit(edit, fitted, file, options, tool);
  return 0;
}

}  // namespace

void addEdit(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EditArguments>();
  CLI::App* command =
      app.add_subcommand("edit", "Edits a material through a fitted model, or applies the edits of a document");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--model", options->model, "Model to fit and edit")->check(CLI::IsMember(modelIds()));
  command
      ->add_option("--set", options->set,
                   "Parameters as name=value or name=red,green,blue, choices by name or index; repeatable")
      ->type_name("NAME=VALUE")
      ->check(parsedBy(checkAssignment));
  command
      ->add_option("--control", options->controls,
                   "Controls as name=value, with the same meaning for every model; 1 (tint: white) changes nothing: " +
                       namesOf(editing::artistControls()))
      ->type_name("NAME=VALUE")
      ->check(parsedBy(checkAssignment));
  command
      ->add_option(
          "--compose", options->composition,
          "Composition of the edit: additive, log-plus or lobes (lobes for models that are sums of lobes, otherwise "
          "additive)")
      ->check(CLI::IsMember(std::vector<std::string>(editing::compositionIds.begin(), editing::compositionIds.end())));
  command->add_flag(
      "--change-albedo", options->changesAlbedo,
      "Let the albedo of highlights change with their width, as Gonio 0.2.0 did; without it, lobes keep it");
  command->add_option("--strength", options->strength, "Fraction of the change that is applied (1)")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--out", options->out,
                   outputHelp("Material file to write") + ", or the edit without measured data (" +
                       std::string(documents::documentSuffix) + ")")
      ->group(outputGroup)
      ->required();
  command->callback([options, &tool] { tool.run = [options, &tool] { return edit(*options, tool); }; });
}

}  // namespace gonio::tool
