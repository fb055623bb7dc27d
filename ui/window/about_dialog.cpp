#include "ui/window/about_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace ui {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About Smithereens"));
  resize(480, 540);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 18, 20, 14);
  auto* title = new QLabel(QStringLiteral("Smithereens " SMITHEREENS_VERSION), this);
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.6);
  large.setWeight(QFont::DemiBold);
  title->setFont(large);
  auto* words = new QTextBrowser(this);
  words->setOpenExternalLinks(true);
  words->setFrameShape(QFrame::NoFrame);
  words->setStyleSheet(QStringLiteral("background: transparent; border: 0; padding: 0;"));
  words->setHtml(
      tr("<p>Dishes of nodes and springs that bend, hiccup, sneeze, fall and break.</p>"
         "<p>After A. Norton, G. Turk, B. Bacon, J. Gerth and P. Sweeney, <i>Animation of fracture by "
         "physical modeling</i>, The Visual Computer, 1991.</p>"
         "<p>Free software under the GNU General Public License, version 3 or later: you may use, share "
         "and change it. It comes without any warranty.</p>"
         "<p><b>Built with</b><br>Qt %1 (LGPL 3)<br>Eigen (MPL 2)<br>oneTBB (Apache 2)<br>Embree (Apache "
         "2)<br>assimp (BSD)<br>nlohmann-json (MIT)<br>Zstandard (BSD)<br>xxHash (BSD)<br>libpng (libpng "
         "licence)<br>"
         "Inter and JetBrains Mono (SIL Open Font License)</p>")
          .arg(QString::fromLatin1(qVersion())));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(title);
  layout->addWidget(words, 1);
  layout->addWidget(buttons);
}

}  // namespace ui
