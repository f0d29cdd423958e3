cli-more-time = { $cure }; more time: --time-limit S
cli-verb-renamed = note: `seamwright { $former }` is now `seamwright { $present }`
cli-folder-not-written = { $folder }: cannot be written: { $why }
cli-unknown-language = note: there is no language `{ $language }`, so this is English; available: { $known }
