# Puts the bundles in FOLDER into the source file OUTPUT: cmake -D FOLDER=... -D TEMPLATE=... -D OUTPUT=... -P embed.cmake
file(READ ${FOLDER}/browse.js BODYLINE_BROWSE_JS)
file(READ ${FOLDER}/browse.css BODYLINE_BROWSE_CSS)
file(READ ${FOLDER}/report_viewer.js BODYLINE_REPORT_VIEWER_JS)
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
