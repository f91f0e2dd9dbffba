// The view in three dimensions of a report, in a browser.
