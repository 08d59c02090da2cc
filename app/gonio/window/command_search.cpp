// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/command_search.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/window/action_table.h"
#include "app/gonio/window/document_files.h"
#include "app/gonio/window/help.h"
#include "core/rendering/environment.h"
#include "core/rendering/scene_file.h"
#include "widgets/library/library_model.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

/// How well an entry matches: each word begins one of its text, or of its text and keywords, or stands anywhere in
/// them.
enum class Match { text, keywords, anywhere, none };

bool beginsAll(const QString& text, const QStringList& words) {
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
  const QStringList own = text.split(between, Qt::SkipEmptyParts);
  return std::ranges::all_of(words, [&](const QString& word) {
    return std::ranges::any_of(own, [&](const QString& one) { return one.startsWith(word, Qt::CaseInsensitive); });
  });
}

Match matchOf(const SearchEntry& entry, const QStringList& words) {
  if (words.isEmpty()) return entry.isCommand ? Match::text : Match::none;
  if (beginsAll(entry.text, words)) return Match::text;
  const QString all = entry.text + ' ' + entry.keywords;
  if (beginsAll(all, words)) return Match::keywords;
  const bool isThere =
      std::ranges::all_of(words, [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
  return isThere ? Match::anywhere : Match::none;
}

void addCommands(std::vector<SearchEntry>& entries, ActionTable& actions) {
  for (const NamedAction& named : actions.all())
    entries.push_back({.text = named.path,
                       .keywords = named.action->toolTip(),
                       .run =
                           [action = QPointer(named.action)] {
                             if (action) action->trigger();
                           },
                       .shortcut = named.action->shortcut().toString(QKeySequence::NativeText),
                       .enabled = named.action->isEnabled(),
                       .isCommand = true});
}

void addMaterials(std::vector<SearchEntry>& entries, const widgets::LibraryModel& model, DocumentFiles& files) {
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.headingOf(row) != widgets::LibraryGrouping::none) continue;
    const QModelIndex index = model.index(row);
    const QString id = index.data(widgets::LibraryModel::IdRole).toString();
    const QString badge = index.data(widgets::LibraryModel::BadgeRole).toString();
    const QString name = index.data().toString();
    entries.push_back({.text = (badge.isEmpty() ? CommandSearch::tr("Library > %1").arg(name)
                                                : CommandSearch::tr("Library > %1 (%2)").arg(name, badge)),
                       .keywords = QString(name).replace('-', ' ') + ' ' +
                                   index.data(widgets::LibraryModel::LookRole).toString() + ' ' +
                                   model.group(row, widgets::LibraryGrouping::kind) + ' ' +
                                   model.group(row, widgets::LibraryGrouping::source) + CommandSearch::tr(" material"),
                       .run = [&files, id] { files.open(id); }});
  }
}

void addRow(std::vector<SearchEntry>& entries, Inspector& inspector, const QString& group,
            const models::ParameterSpec& spec, QWidget* row) {
  if (!row) return;
  const QPointer<QWidget> found = row;
  entries.push_back({.text = QStringLiteral("%1 > %2").arg(group, widgets::toQString(spec.label)),
                     .keywords = widgets::toQString(spec.id) + ' ' + widgets::toQString(spec.description) + ' ' +
                                 CommandSearch::tr("slider parameter"),
                     .run =
                         [&inspector, found] {
                           if (found) inspector.reveal(*found);
                         },
                     .enabled = row->isEnabled()});
}

void addSliders(std::vector<SearchEntry>& entries, const Document& document, Inspector& inspector) {
  const auto* edit = document.active<editing::DifferentialEdit>();
  if (!edit) return;
  const auto& controls = editing::artistControls().parameters;
  for (std::size_t i = 0; i < controls.size(); ++i)
    addRow(entries, inspector, CommandSearch::tr("Controls"), controls[i],
           inspector.controls()->row(editing::ArtistControl(i)));
  const models::ModelSpec& spec = edit->model->spec();
  for (std::size_t i = 0; i < std::min(spec.parameters.size(), inspector.parameters()->rowCount()); ++i)
    addRow(entries, inspector, widgets::toQString(spec.name), spec.parameters[i], inspector.parameters()->row(i));
}

void addModels(std::vector<SearchEntry>& entries, bool isOpen, DocumentController& controller) {
  for (const models::Model* model : models::allModels())
    entries.push_back({.text = CommandSearch::tr("Model > %1").arg(widgets::toQString(model->spec().name)),
                       .keywords = widgets::toQString(model->spec().id) + ' ' +
                                   widgets::toQString(model->spec().id).remove('-') + ' ' +
                                   CommandSearch::tr("choose fit"),
                       .run = [&controller, model] { controller.chooseModel(*model); },
                       .enabled = isOpen});
}

void addScenes(std::vector<SearchEntry>& entries, ScenePanel& scene, EnvironmentController& environment) {
  for (const std::string& name : rendering::bundledSceneNames())
    entries.push_back({.text = CommandSearch::tr("Scene > %1").arg(sceneTitle(name)),
                       .keywords = CommandSearch::tr("shape mesh object show on"),
                       .run = [&scene, name] { scene.open(QString::fromStdString(name)); }});
  QStringList lights;
  for (const std::string& name : rendering::bundledEnvironmentNames()) lights << QString::fromStdString(name);
  for (const QString& light : lights + environment.recent())
    entries.push_back({.text = CommandSearch::tr("Light > %1")
                                   .arg(light.contains('/') ? light.section('/', -1) : sceneTitle(light.toStdString())),
                       .keywords = CommandSearch::tr("environment hdri hdr exr lighting illumination"),
                       .run = [&environment, light] { environment.open(light); }});
}

void addGuide(std::vector<SearchEntry>& entries, QWidget* window) {
  QString page;
  for (const GuidePage& one : guidePages()) {
    if (one.level == 1) page = one.title;
    entries.push_back({.text = one.level == 1 ? CommandSearch::tr("Guide > %1").arg(page)
                                              : CommandSearch::tr("Guide > %1 > %2").arg(page, one.title),
                       .keywords = CommandSearch::tr("help documentation manual"),
                       .run = [window, one] { openGuide(window, one.file, one.level == 1 ? QString() : one.title); }});
  }
}

}  // namespace

CommandSearch::CommandSearch(const Parts& parts, QWidget* window)
    : QDialog(window, Qt::Popup), m_text(new QLineEdit(this)), m_list(new QListWidget(this)) {
  addCommands(m_entries, parts.actions);
  addSliders(m_entries, parts.document, parts.inspector);
  addModels(m_entries, parts.document.material() != nullptr, parts.controller);
  addScenes(m_entries, parts.scene, parts.environment);
  addMaterials(m_entries, parts.library, parts.files);
  addGuide(m_entries, window);
  m_text->setPlaceholderText(tr("Search commands, materials, parameters, scenes"));
  m_text->setAccessibleName(tr("Search commands, materials, parameters, scenes"));
  m_list->setAccessibleName(tr("Search results"));
  m_list->setFocusPolicy(Qt::NoFocus);
  m_text->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_text);
  layout->addWidget(m_list);
  const int em = fontMetrics().height();
  resize(em * 32, em * 24);
  move(window->mapToGlobal(QPoint((window->width() - width()) / 2, em * 4)));
  connect(m_text, &QLineEdit::textChanged, this, &CommandSearch::filter);
  connect(m_list, &QListWidget::itemActivated, this, &CommandSearch::runCurrent);
  connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::runCurrent);
  filter({});
  m_text->setFocus();  // a popup takes no focus by itself
}

void CommandSearch::add(int entry) {
  const SearchEntry& one = m_entries[std::size_t(entry)];
  auto* item =
      new QListWidgetItem(one.shortcut.isEmpty() ? one.text : one.text + QStringLiteral("    ") + one.shortcut);
  item->setData(Qt::UserRole, entry);
  if (!one.enabled) item->setFlags(Qt::NoItemFlags);
  m_list->addItem(item);
}

void CommandSearch::filter(const QString& text) {
  m_list->clear();
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  std::vector<Match> matches;
  for (const SearchEntry& entry : m_entries) matches.push_back(matchOf(entry, words));
  for (const Match match : {Match::text, Match::keywords, Match::anywhere})
    for (int i = 0; i < int(m_entries.size()); ++i)
      if (matches[std::size_t(i)] == match) add(i);
  if (m_list->count() == 0) {
    auto* none = new QListWidgetItem(tr("No entry matches \"%1\".").arg(text));
    none->setFlags(Qt::NoItemFlags);
    m_list->addItem(none);
  }
  m_list->setCurrentRow(0);
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    runCurrent();
    return true;
  }
  if (key == Qt::Key_Up || key == Qt::Key_Down) {
    const int row = m_list->currentRow() + (key == Qt::Key_Down ? 1 : -1);
    m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void CommandSearch::runCurrent() {
  const QListWidgetItem* item = m_list->currentItem();
  // In some styles a click activates the item as well.
  if (!isVisible() || !item || !(item->flags() & Qt::ItemIsEnabled)) return;
  // Afterwards: it may open a dialog with an event loop of its own, which would destroy the list that handles this
  // click.
  QMetaObject::invokeMethod(parentWidget(), m_entries[std::size_t(item->data(Qt::UserRole).toInt())].run,
                            Qt::QueuedConnection);
  accept();
}

}  // namespace gonio::app

#include "moc_command_search.cpp"
