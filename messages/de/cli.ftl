cli-more-time = { $cure }; mehr Zeit: --time-limit S
cli-verb-renamed = Hinweis: `seamwright { $former }` heißt jetzt `seamwright { $present }`
cli-folder-not-written = { $folder }: lässt sich nicht schreiben: { $why }
cli-unknown-language = Hinweis: die Sprache `{ $language }` gibt es nicht, daher Englisch; verfügbar: { $known }
