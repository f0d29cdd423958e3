import type { Language } from './catalogue';

const FILES = import.meta.glob<Record<string, string>>('../../../messages/*/shipped.json', { import: 'default' });

/** Comments and titles of supplied files in a language, by their English text: users edit copies of these files, so they have no codes. */
export async function loadShipped(language: Language): Promise<Record<string, string>> {
  return (await Object.entries(FILES).find(([path]) => path.endsWith(`/${language}/shipped.json`))?.[1]()) ?? {};
}
