import answers from '../../../words/answers.json';
import findings from '../../../words/findings.json';
import hints from '../../../words/hints.json';
import notes from '../../../words/notes.json';
import refusals from '../../../words/refusals.json';
import type { Language } from './index.svelte';
import { matcher, ofRow } from './patterns';

/**
 * What the cell says of a plan in whole sentences, with holes for what stands in them. Plans are told in English on the command line and
 * in report.json; the panel and reports find the sentence again by its pattern. A test holds the English against the cell's sources: `|` parts
 * what is written there in several places.
 */
export const rows = findings as [string, string, string, string, string][];

/** What is said of a weld, in its events and notes: reports have it too. */
export const ofWelds = notes as [string, string, string, string, string][];

/** What is wrong with a job's text, and what is allowed. */
export const ofJobs = refusals as [string, string, string, string, string][];

/** Why the panel's server refuses what is asked of it, and what part programs are proven by. */
export const ofAnswers = answers as [string, string, string, string, string][];

/** Comments and titles in the files that ship, whole: users' own stay as they are. */
export const ofFiles = hints as [string, string, string, string, string][];

/** A sentence of the cell in a language; what has no words here stays as it came. */
export const sentence = matcher([...rows, ...ofWelds, ...ofJobs, ...ofAnswers].map(ofRow));

const SHIPPED = new Map(ofFiles.map(ofRow));

/** A comment or title of a file that ships in a language; a user's own stays as it is. */
export function shipped(text: string, language: Language): string {
  return language === 'en' ? text : (SHIPPED.get(text)?.(language) ?? text);
}
