# cmake -DFOLDER=Web -DOUTPUT=page.html -P bundle.cmake
#
# Puts the files of a page together: page.html with the style, and with the modules of modules.txt as one script. The
# page's Content-Security-Policy names both by their hashes. {{TITLE}} and {{DATA}} are left for the page's writer.

# The base64 text of a hash of 64 hexadecimal digits.
function (base64_of_hash hex result)
  set(alphabet "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  set(text "")
  foreach (at RANGE 0 60 6) # 32 bytes are ten groups of 24 bits and one of 16
    string(SUBSTRING "${hex}0000" ${at} 6 digits)
    math(EXPR bits "0x${digits}")
    foreach (shift 18 12 6 0)
      math(EXPR index "(${bits} >> ${shift}) & 63")
      string(SUBSTRING "${alphabet}" ${index} 1 letter)
      string(APPEND text "${letter}")
    endforeach ()
  endforeach ()
  string(SUBSTRING "${text}" 0 43 text)
  set("${result}" "${text}=" PARENT_SCOPE)
endfunction ()

function (put name value)
  string(FIND "${page}" "{{${name}}}" at)
  if (at LESS 0)
    message(FATAL_ERROR "page.html has no {{${name}}}")
  endif ()
  string(REPLACE "{{${name}}}" "${value}" text "${page}")
  set(page "${text}" PARENT_SCOPE)
endfunction ()

file(READ "${FOLDER}/page.html" page)
file(READ "${FOLDER}/style.css" style)
file(STRINGS "${FOLDER}/modules.txt" modules REGEX "^[a-z]")
set(script "\n\"use strict\";\n")
foreach (module IN LISTS modules)
  file(READ "${FOLDER}/${module}" text)
  string(REGEX REPLACE "(^|\n)import [^\n]*;" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(APPEND script "${text}")
endforeach ()
string(SHA256 script_hash "${script}")
string(SHA256 style_hash "${style}")
base64_of_hash("${script_hash}" script_hash)
base64_of_hash("${style_hash}" style_hash)
put(CSP "default-src 'none'; script-src 'sha256-${script_hash}'; style-src 'sha256-${style_hash}'; img-src data: blob:; base-uri 'none'; form-action 'none'")
put(STYLE "${style}")
put(SCRIPT "${script}")
file(WRITE "${OUTPUT}" "${page}")
