#!/usr/bin/env bash
# ImageMagick shows Radiance pictures that are stored from the bottom up upside down, and loses old run lengths.
#
# Expected: the resolution line of a Radiance picture states its order: "-Y 2 +X 4" from the top down, "+Y 2 +X 4"
#   from the bottom up. A pixel with mantissas 1 1 1 repeats the one before it (Radiance's file formats, "old" run
#   lengths; any program may write them, and mix them with plain pixels).
# Happens: "+Y" is read as if it were "-Y", without a word. Of two rows of one pixel and a run of three, the run's
#   pixel becomes black, the next row stands in the first, and what is left is black: a message, but a picture too.
# Versions: ImageMagick 6.9.11.60 as packaged in Debian 12 (8:6.9.11.60+dfsg-1.6+deb12u15).
# Matters: an environment that is turned over with it lights from below. Convert such pictures by another program,
#   and compare one pixel.
set -euo pipefail

version='8:6.9.11.60+dfsg-1.6+deb12u15'
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir packages && chmod 777 packages
(cd packages && apt-get download --quiet "imagemagick-6.q16=$version" "libmagickcore-6.q16-6=$version" \
  "libmagickwand-6.q16-6=$version" libbrotli1 libbsd0 libbz2-1.0 libexpat1 libfftw3-double3 libfontconfig1 \
  libfreetype6 libglib2.0-0 libgomp1 libicu72 liblcms2-2 liblqr-1-0 libltdl7 liblzma5 libmd0 libpcre2-8-0 \
  libpng16-16 libx11-6 libxau6 libxcb1 libxdmcp6 libxext6 libxml2 zlib1g >/dev/null 2>download.log) ||
  { cat packages/download.log; exit 2; }
for package in packages/*.deb; do dpkg -x "$package" unpacked; done
libraries=("$folder"/unpacked/usr/lib/*-linux-gnu "$folder"/unpacked/lib/*-linux-gnu)
coders=("$folder"/unpacked/usr/lib/*-linux-gnu/ImageMagick-*/modules-Q16/coders)
# pixels FILE: its numbers, row by row, as text.
pixels() {
  LD_LIBRARY_PATH="$(IFS=:; echo "${libraries[*]}")" MAGICK_CODER_MODULE_PATH="${coders[0]}" \
    "$folder/unpacked/usr/bin/convert-im6.q16" "$1" -depth 8 txt:- 2>messages | tail -n +2 || true
}
python3 - <<'SCRIPT'
def write(name, resolution, pixels):
    head = b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n' + resolution + b'\n'
    open(name, 'wb').write(head + b''.join(bytes(pixel) for pixel in pixels))
dark, light, thrice = (16, 16, 16, 128), (128, 128, 128, 128), (1, 1, 1, 3)
write('down.hdr', b'-Y 2 +X 4', 4 * [light] + 4 * [dark])
write('up.hdr', b'+Y 2 +X 4', 4 * [dark] + 4 * [light])
write('runs.hdr', b'-Y 2 +X 4', [light, thrice, dark, thrice])
SCRIPT
pixels down.hdr >down.txt
[[ "$(wc -l <down.txt)" == 8 ]] || { cat messages; exit 2; }
pixels up.hdr >up.txt
pixels runs.hdr >runs.txt
echo "the same picture, light above: its first and last pixel"
for name in down up runs; do
  echo "$name: $(head -n 1 "$name.txt" | cut -d' ' -f2)   $(tail -n 1 "$name.txt" | cut -d' ' -f2)"
done
turned_over() { [[ "$(head -n 4 up.txt | cut -d' ' -f2)" == "$(tail -n 4 down.txt | cut -d' ' -f2)" ]]; }
if turned_over && ! cmp -s runs.txt down.txt; then
  echo 'as described'
else
  echo 'not as described'
  exit 1
fi
